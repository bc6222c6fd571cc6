// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_law.h"
#include "solver/newton_report.h"
#include "solver/solid_residual.h"

#include <vector>

namespace Signorini
{
  /// Forces out of balance, and what they have to be small beside: when Newton's method may stop.
  class ConvergenceCriteria
  {
  public:
    /// Refers to both.
    ConvergenceCriteria(const SolidResidual &bodies, const ContactLaw &law, double tolerance);

    void
    set_tolerance(const double wanted)
    {
      tolerance = wanted;
    }

    /// Forget the forces that there were.
    void
    restart();

    /// Forces of the bodies and of contact, zero where the displacement is prescribed.
    /// @param in at u, with the traction that counts
    LA::Vector
    residual(const LA::Vector &u, const LawInputs &in, const LA::Vector &status);

    // Of the last one:

    /// The forces that gaps ask for, see ContactLaw::residual(). Where surfaces overlap before
    /// anything else acts, they are all that tells what is small.
    void
    set_gap_forces(const double forces)
    {
      gap_forces = forces;
    }

    /// The forces at work; where there are none, those that gaps ask for; 1 if there are none
    /// either.
    double
    scale() const
    {
      return force_scale > 0 ? force_scale : gap_forces > 0 ? gap_forces : 1.;
    }

    /// Those at work in the body where they are smallest.
    double
    smallest_reference_force() const;
    /// Relative to the forces at work, that of the body where it is largest.
    double
    residual_of_bodies(const LA::Vector &r) const;

    /// That one.
    unsigned int
    worst_body(const LA::Vector &r) const;

    /// Forces and the active set are those of a solution; with augmentations, of the present one.
    /// @param before residual of the last step, to see that it does not fall any more
    bool
    is_force_converged(const NewtonStep &step, double before) const;
    /// So are the gaps.
    bool
    is_gap_converged(const NewtonStep &step) const;

  private:
    /// Body by body, what residuals have to be small beside. That of all, which a support that
    /// moves a stiff body makes large though the body is free of stress in the end, is not what
    /// acts on a soft one; so it counts up to a thousand times the contact force.
    std::vector<double>
    reference_forces(const LA::Vector &contact_force, double scale) const;
    std::vector<double>
    residuals_of_bodies(const LA::Vector &r) const;
    /// Of the parts of a vector.
    std::vector<double>
    norms_of_bodies(const LA::Vector &force) const;
    /// Of the bodies' forces, and of penalties, which multiply that of the gap; in the norm of the
    /// residual.
    double
    rounding(const LA::Vector &u, const LawInputs &in, const LA::Vector &status) const;

    const SolidResidual &bodies;
    const ContactLaw    &law;
    const GapOperator   &contact;
    double               tolerance;
    unsigned int         n_bodies    = 0;
    double               force_scale = 0, largest_force = 0, force_rounding = 0, gap_forces = 0;
    std::vector<double>  my_reference_forces; ///< reference_forces() now

    mutable LA::Vector   stiffness_diagonal;
    mutable unsigned int version = 0; ///< of the stiffness that it is of
  };
} // namespace Signorini
