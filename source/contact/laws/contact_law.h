// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"

#include <deal.II/base/tensor.h>

namespace Signorini
{
  /// The components of a vector at a contact point: normal, then tangential if the law has any.
  /// Components that the law does not have are zero.
  using LawVector = dealii::Tensor<1, 3>;
  /// A matrix over the components, [a][b].
  using LawMatrix = dealii::Tensor<2, 3>;

  /// The internal variables of a contact law at a point, which carry its history from one load step
  /// to the next.
  struct InternalVariables
  {
    std::vector<LawVector> vectors; ///< along the tangents: component 0 is zero
    std::vector<double>    scalars;
  };

  /// The input of a contact law at a contact point.
  struct LawInput
  {
    /// The normal gap g, positive when open, then the slip of this load step, that of the slave
    /// relative to the master [length].
    LawVector gap;
    /// The traction of the bodies' stress, normal component positive in compression
    /// [force/length^2]; for Nitsche's method.
    LawVector stress;
    /// The contact pressure p and the tangential traction on the slave, if they are unknowns
    /// [force/length^2].
    LawVector         traction;
    InternalVariables internal; ///< at the end of the last load step
  };

  /// The response of a contact law at a point. All entries are zero at an open point.
  struct LawResponse
  {
    /// Pressure, positive in compression, and tangential traction on the slave.
    LawVector traction;
    /// Derivatives [a][b] of component a of the traction, if it follows from the law: by component
    /// b of the gap [force/length^3] and of the stress [-].
    LawMatrix by_gap, by_stress;
    /// Residual of the constraint [length]: the gap minus the gap at which the law holds. For laws
    /// with multipliers it is zero at the solution.
    LawVector residual;
    /// Derivatives of the residual by the gap [-], and by the traction as an independent unknown
    /// [length^3/force].
    LawMatrix         residual_by_gap, residual_by_traction;
    InternalVariables internal; ///< at the end of this load step
  };

  /// The inputs of a law at all points; refers to the vectors. Each has one vector for each
  /// component, see PointVectors.
  struct LawInputs
  {
    const PointVectors   &gap, &stress, &traction;
    const InternalFields &internal;

    /// The input of one point of this rank.
    LawInput
    at(dealii::types::global_dof_index point) const;
  };

  /// A contact law: the relation between gap, stress and traction at the contact points, with one
  /// component (NormalContact) or as many as the dimension. Newton's method, the linear system,
  /// line searches, the active set and the dual problem use this interface and nothing else.
  ///
  /// Each point is evaluated by itself, for a given status: the active-set strategy chooses the
  /// statuses.
  class ContactLaw
  {
  public:
    using Index = dealii::types::global_dof_index;

    virtual ~ContactLaw() = default;

    /// The gap operator that the law was made for.
    const GapOperator &
    gap_operator() const
    {
      return contact;
    }

    /// The number of components of all points: 1, or as many as the dimension.
    unsigned int
    n_components() const
    {
      return contact.n_components();
    }

    /// True if the traction is an independent unknown (Lagrange multiplier), false if it follows
    /// from the law.
    virtual bool
    has_multiplier() const = 0;

    /// True if the linearisation is symmetric at all points, whatever their status.
    virtual bool
    is_symmetric() const
    {
      return true;
    }

    /// True if the derivatives depend on the status of a point alone, not on the other inputs.
    virtual bool
    has_constant_derivatives() const
    {
      return true;
    }

    /// The internal variables of a point that has never been closed: all zero, as many as the law
    /// needs.
    virtual InternalVariables
    initial_variables() const
    {
      return {};
    }

    /// True if the law depends on the traction of the last solution, which augment() sets
    /// (augmented Lagrangian method of Uzawa type).
    virtual bool
    augments() const
    {
      return false;
    }

    /// Set the traction of the last solution.
    virtual void
    augment(const PointVectors & /*traction*/)
    {}

    /// Multiply the penalty by a factor, for penalty continuation from a start far from the
    /// solution. Returns true if that changes the law.
    virtual bool
    scale_penalty(double /*factor*/)
    {
      return false;
    }

    /// True while the penalty is reduced by scale_penalty().
    virtual bool
    has_scaled_penalty() const
    {
      return false;
    }

    /// Let derivatives be those of a bound of friction that is given, as in the law of Tresca, or
    /// those of one that depends on the pressure, until called again. Returns false if the law has
    /// no friction.
    virtual bool
    give_friction_bound(bool /*given*/)
    {
      return false;
    }

    /// The factor that reduces all penalties to at most E/h; 1 if the law gains nothing from
    /// continuation. Collective.
    virtual double
    minimal_penalty_scale() const
    {
      return 1;
    }

    /// The trial traction, which determines the status: the traction without the bounds of the law.
    /// Its normal component is positive where the point is in compression.
    virtual LawVector
    trial(Index point, const LawInput &in) const = 0;

    /// The status that the trial traction implies.
    virtual ContactStatus
    status(Index point, const LawVector &trial) const = 0;

    /// The response of a point for a given status (doc/theory, (2.21)), all zero at open points.
    virtual LawResponse
    response(Index point, const LawInput &in, ContactStatus status) const = 0;

    /// The trial tractions at all points if the traction is known from a former mesh or load step.
    virtual PointVectors
    trial_from_traction(const LawInputs &in) const
    {
      return trial(in);
    }

    /// The stiffness that converts a residual [length] to a pressure; times the area it is a force
    /// [force/length^3].
    virtual double
    residual_stiffness(const Index point) const
    {
      return contact.coefficients.stiffness(point);
    }

    // The functions above, evaluated at all points of this rank:

    /// The trial tractions.
    PointVectors
    trial(const LawInputs &in) const;

    /// The statuses that the trial tractions imply, values of ContactStatus.
    LA::Vector
    status(const PointVectors &trial) const;

    /// The tractions at given statuses. One that is an independent unknown is kept where the point
    /// is not open.
    PointVectors
    traction(const LawInputs &in, const LA::Vector &status) const;

    /// The residuals of the constraints as forces, see residual_stiffness().
    PointVectors
    residual(const LawInputs &in, const LA::Vector &status) const;

    /// Internal variables at the end of this load step.
    InternalFields
    internal(const LawInputs &in, const LA::Vector &status) const;

    /// initial_variables() at all points.
    InternalFields
    initial_fields() const;

  protected:
    /// Keeps a reference to the gap operator.
    explicit ContactLaw(const GapOperator &contact)
      : contact(contact)
    {}

    /// Evaluate f(point), which returns a LawVector, at all points of this rank.
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
