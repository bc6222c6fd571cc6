#pragma once

#include <signorini/contact/discretisation/gap_operator.h>

#include <deal.II/base/tensor.h>

namespace Signorini
{
  /// Components of a contact point: the normal one first, then those along the surface, if the law
  /// has any. What a law does not have stays zero.
  using LawVector = dealii::Tensor<1, 3>;
  using LawMatrix = dealii::Tensor<2, 3>;

  /// What a law is asked with at a contact point.
  struct LawInput
  {
    LawVector gap;      ///< g, positive when open
    LawVector stress;   ///< s of the bodies, positive in compression
    LawVector pressure; ///< p, if it is an unknown
  };

  /// What it says there. All is zero where it is not active.
  struct LawResponse
  {
    LawVector pressure;     ///< p, positive in compression
    LawMatrix dp_dg, dp_ds; ///< of a pressure that follows [force/length^3], [-]
    LawVector defect;       ///< what the gap lacks; 0 under an unknown pressure
    LawVector compliance;   ///< d defect/dp of an unknown pressure, component by component
  };

  /// The inputs at all points; refers to them.
  struct LawInputs
  {
    const LA::Vector &gap, &stress, &pressure;

    /// @param first row of a point
    /// @param n components
    LawInput
    at(dealii::types::global_dof_index first, unsigned int n) const;
  };

  /// The relation between gap, normal stress and pressure at the contact points, of which there are
  /// laws for one component a point (NormalContact) or more: then as many rows of the gap operator,
  /// one after the other, are those of a point. System, line search, active set and output ask this
  /// and nothing else.
  ///
  /// Points are asked one by one, and told whether they count as active: that is the choice of the
  /// strategy that looks for the set.
  class ContactLaw
  {
  public:
    using Index = dealii::types::global_dof_index;

    virtual ~ContactLaw() = default;

    const GapOperator &
    gap_operator() const
    {
      return contact;
    }

    /// Rows of the gap operator a point.
    virtual unsigned int
    n_components() const
    {
      return 1;
    }

    /// True: the pressure is an unknown.
    virtual bool
    is_mixed() const = 0;

    /// True: the law refers to the pressure of the last solution, see augment().
    virtual bool
    augments() const
    {
      return false;
    }

    /// Let that pressure be this one from now on.
    virtual void
    augment(const LA::Vector & /*pressure*/)
    {}

    /// Multiply stiff springs by that, for a start far from the solution. True if that changes the
    /// law.
    virtual bool
    soften(double /*factor*/)
    {
      return false;
    }

    virtual bool
    is_soft() const
    {
      return false;
    }

    /// The factor with which no spring is stiffer than E/h; 1 where nothing is gained by that.
    /// Collective.
    virtual double
    softest() const
    {
      return 1;
    }

    /// What the active set is decided by, positive where a point pushes.
    /// @param i its first row
    virtual double
    trial(Index i, const LawInput &in) const = 0;

    /// Is the point active by itself?
    virtual bool
    pushes(Index i, double trial) const = 0;

    virtual LawResponse
    response(Index i, const LawInput &in, bool active) const = 0;

    /// Of the trial values at all points, where the pressure of a former mesh is known.
    virtual LA::Vector
    trial_from_pressure(const LawInputs &in) const
    {
      return trial(in);
    }

    /// By what a defect is multiplied, beside its area, so that it becomes a force.
    virtual double
    defect_stiffness(const Index i) const
    {
      return contact.coefficients.stiffness(i);
    }

    // The same at all points; rows of a point have the same trial value.

    LA::Vector
    trial(const LawInputs &in) const;

    /// 1 where the point is active by itself, else 0.
    LA::Vector
    pushes(const LA::Vector &trial) const;

    /// An unknown one is left as it is where active.
    LA::Vector
    pressure(const LawInputs &in, const LA::Vector &active) const;

    /// As forces, see defect_stiffness().
    LA::Vector
    defect(const LawInputs &in, const LA::Vector &active) const;

  protected:
    /// Refers to it.
    explicit ContactLaw(const GapOperator &contact)
      : contact(contact)
    {}

    /// What f(first row of a point) returns, a LawVector, at all points.
    template <typename F>
    LA::Vector
    at_all_points(const F &f) const;

    const GapOperator &contact;
  };
} // namespace Signorini
