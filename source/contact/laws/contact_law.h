// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"

#include <deal.II/base/tensor.h>

namespace Signorini
{
  /// Components of a contact point: the normal one first, then those along the tangents, if the law
  /// has any. What a law does not have stays zero.
  using LawVector = dealii::Tensor<1, 3>;
  using LawMatrix = dealii::Tensor<2, 3>;

  /// What a law remembers of a contact point from one load step to the next.
  struct InternalVariables
  {
    std::vector<LawVector> vectors; ///< along the tangents: component 0 is zero
    std::vector<double>    scalars;
  };

  /// What a law is asked with at a contact point.
  struct LawInput
  {
    /// The normal gap g, positive when open, then the slip of this load step, that of the slave
    /// relative to the master [length].
    LawVector gap;
    /// Of the bodies, normal component positive in compression [force/length^2].
    LawVector stress;
    /// The contact pressure p and the tangential traction on the slave, if they are unknowns
    /// [force/length^2].
    LawVector         traction;
    InternalVariables internal; ///< at the end of the last load step
  };

  /// What the law says there. All is zero at an open point.
  struct LawResponse
  {
    /// Pressure, positive in compression, and tangential traction on the slave.
    LawVector traction;
    /// Derivatives of a traction that follows [a][b]: of component a by component b of the gap
    /// [force/length^3], and of the stress [-].
    LawMatrix by_gap, by_stress;
    /// Residual of the constraint [length]: what the gap lacks for the law to hold. Of laws with
    /// multipliers it is zero at the solution.
    LawVector residual;
    /// Its derivatives by the gap [-], and by the traction that is an unknown
    /// [length^3/force].
    LawMatrix         residual_by_gap, residual_by_traction;
    InternalVariables internal; ///< at the end of this load step
  };

  /// The inputs at all points; refers to them. Vectors have a component each, see PointVectors; of
  /// the stress there may be the normal one alone.
  struct LawInputs
  {
    const PointVectors   &gap, &stress, &traction;
    const InternalFields &internal;

    LawInput
    at(dealii::types::global_dof_index point) const;
  };

  /// The relation between gap, stress and traction at the contact points, with one component
  /// (NormalContact), or with as many as the dimension. Newton's method, the linear system, line
  /// searches, the active set and the dual problem ask this and nothing else.
  ///
  /// Points are asked one by one, and told the status that they are taken to have: that is the
  /// choice of the strategy that looks for the set.
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

    /// 1, or as many as the dimension, of all points.
    unsigned int
    n_components() const
    {
      return contact.n_components();
    }

    /// True: the traction is an unknown.
    virtual bool
    has_multiplier() const = 0;

    /// True: the linearisation is symmetric at all points, whatever their status.
    virtual bool
    is_symmetric() const
    {
      return true;
    }

    /// True: derivatives depend on the status of a point alone, not on what else it is asked with.
    virtual bool
    has_constant_derivatives() const
    {
      return true;
    }

    /// All zero, as of points that have never been closed: as many as the law needs.
    virtual InternalVariables
    initial_variables() const
    {
      return {};
    }

    /// True: the law refers to the traction of the last solution, see augment().
    virtual bool
    augments() const
    {
      return false;
    }

    /// Let that traction be this one from now on.
    virtual void
    augment(const PointVectors & /*traction*/)
    {}

    /// Multiply stiff springs by that, for a start far from the solution. True if that changes the
    /// law.
    virtual bool
    scale_penalty(double /*factor*/)
    {
      return false;
    }

    virtual bool
    has_scaled_penalty() const
    {
      return false;
    }

    /// The factor with which no spring is stiffer than E/h; 1 where nothing is gained by that.
    /// Collective.
    virtual double
    minimal_penalty_scale() const
    {
      return 1;
    }

    /// The traction that the status is decided by: what the law would answer if nothing bounded it.
    /// Its normal component is positive where the point presses.
    virtual LawVector
    trial(Index point, const LawInput &in) const = 0;

    /// The status that the point has by itself.
    virtual ContactStatus
    status(Index point, const LawVector &trial) const = 0;

    virtual LawResponse
    response(Index point, const LawInput &in, ContactStatus status) const = 0;

    /// Of the trial tractions at all points, where the traction of a former mesh is known.
    virtual PointVectors
    trial_from_traction(const LawInputs &in) const
    {
      return trial(in);
    }

    /// By what a residual is multiplied, beside the area, so that it becomes a force.
    virtual double
    residual_stiffness(const Index point) const
    {
      return contact.coefficients.stiffness(point);
    }

    // The same at all points of this rank:

    PointVectors
    trial(const LawInputs &in) const;

    /// Values of ContactStatus.
    LA::Vector
    status(const PointVectors &trial) const;

    /// An unknown one is left as it is where the point is not open.
    PointVectors
    traction(const LawInputs &in, const LA::Vector &status) const;

    /// As forces, see residual_stiffness().
    PointVectors
    residual(const LawInputs &in, const LA::Vector &status) const;

    /// Internal variables at the end of this load step.
    InternalFields
    internal(const LawInputs &in, const LA::Vector &status) const;

    /// initial_variables() at all points.
    InternalFields
    initial_fields() const;

  protected:
    /// Refers to it.
    explicit ContactLaw(const GapOperator &contact)
      : contact(contact)
    {}

    /// What f(point) returns, a LawVector, at all points.
    template <typename F>
    PointVectors
    at_all_points(const F &f) const;

    const GapOperator &contact;
  };



  template <typename F>
  PointVectors
  ContactLaw::at_all_points(const F &f) const
  {
    PointVectors result(n_components(), contact.zero());
    for (const Index i : contact.weight.locally_owned_elements())
      {
        const LawVector values = f(i);
        for (unsigned int a = 0; a < result.size(); ++a)
          result[a](i) = values[a];
      }
    for (LA::Vector &component : result)
      component.compress(dealii::VectorOperation::insert);
    return result;
  }
} // namespace Signorini
