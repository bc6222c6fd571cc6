// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_law.h"
#include "solver/newton_report.h"
#include "solver/solid_residual.h"

#include <vector>

namespace Signorini
{
  /// The residual of Newton's method, and the convergence criteria: the forces that it is measured
  /// against.
  class ConvergenceCriteria
  {
  public:
    /// Keeps references to both.
    ConvergenceCriteria(const SolidResidual &bodies, const ContactLaw &law, double tolerance);

    /// Set the tolerance of residuals, relative to the scales of forces.
    void
    set_tolerance(const double wanted)
    {
      tolerance = wanted;
    }

    /// Discard the forces of earlier iterates.
    void
    restart();

    /// The residual of solids and contact, zero where the displacement is prescribed. Collective.
    /// @param in at u, with the present traction
    LA::Vector
    residual(const LA::Vector &u, const LawInputs &in, const LA::Vector &status);

    // Results for the last residual():

    /// Set the norm of the gap residuals as forces, see ContactLaw::residual(). If bodies penetrate
    /// each other initially and nothing else acts, it is the only scale of forces.
    void
    set_gap_forces(const double forces)
    {
      gap_forces = forces;
    }

    /// The scale of forces: the acting ones; if there are none, those of the gap residuals; if
    /// these vanish too, 1.
    double
    scale() const
    {
      return force_scale > 0 ? force_scale : gap_forces > 0 ? gap_forces : 1.;
    }

    /// The reference force of the body where it is smallest.
    double
    smallest_reference_force() const;
    /// The largest residual of a body, relative to its reference force. Collective.
    double
    residual_of_bodies(const LA::Vector &r) const;

    /// The body with the largest relative residual. Collective.
    unsigned int
    worst_body(const LA::Vector &r) const;

    /// True if residual and active set are converged; with augmentations, those of the present one.
    /// @param before residual of the last step, to detect stagnation at rounding level
    bool
    is_force_converged(const NewtonStep &step, double before) const;
    /// True if the gap residual is converged.
    bool
    is_gap_converged(const NewtonStep &step) const;

  private:
    /// The reference force of each body. The force of all bodies together, which a support that
    /// displaces a stiff body makes large even if that body is free of stress in the end, says
    /// nothing about a soft body; so it counts only up to a thousand times the contact force of the
    /// body. Collective.
    std::vector<double>
    reference_forces(const LA::Vector &contact_force, double scale) const;
    /// The norms of the residuals of bodies, relative to their reference forces.
    std::vector<double>
    residuals_of_bodies(const LA::Vector &r) const;
    /// The norm of the part of a vector that belongs to each body. Collective.
    std::vector<double>
    norms_of_bodies(const LA::Vector &force) const;
    /// The rounding error of the residual, in its norm: that of internal forces, and that of the
    /// gap times penalties.
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
