// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/section.h>
#include <signorini/solver/newton_settings.h>

namespace Signorini
{
  void
  NewtonSettings::declare(Section &section)
  {
    section.add("Maximum steps", maximum_steps, "of Newton's method in one load step", positive);
    section.add("Tolerance",
                tolerance,
                "of the nonlinear residual, relative to the acting forces",
                Range{0, 1e-3, false});
    section.add(
      "Geometry tolerance",
      of_geometry,
      "of the nonlinear residual between updates of the contact geometry (Contact geometry = updated)",
      Range{0, 1e-3, false});
    section.rename_key("Reduction", "Forcing term");
    section.add(
      "Forcing term",
      reduction,
      "relative tolerance of the linear solves while the active set changes (inexact Newton method; at most 1e-6 "
      "if the active set cycles, or after ten changes); the last one satisfies the Tolerance",
      Range{0, 1, false, false});
    section.add(
      "Stabilisation",
      stabilisation,
      "stiffness, in units of E times size, of rigid-body modes that are constrained by contact alone, as long as contact is "
      "open; the result does not depend on it",
      positive);
    section.rename_key("Undetermined motions", "Unconstrained modes");
    section.rename_choice("Unconstrained modes", "refuse", "error");
    section.rename_choice("Unconstrained modes", "hold", "stabilise");
    section.add_choice(
      "Unconstrained modes",
      undetermined_modes,
      {{"error", UnconstrainedModeTreatment::refuse},
       {"stabilise", UnconstrainedModeTreatment::hold}},
      "rigid-body modes that neither supports nor contact constrain, as the rotation of a pin: error; or stabilise "
      "them, if that takes less than 1 % of the contact force");
  }



  std::string
  NewtonSettings::stabilisation_advice()
  {
    return "prescribe a displacement that constrains it, or set Newton/Unconstrained modes = stabilise, "
           "which adds a stabilisation and reports its force";
  }
} // namespace Signorini
