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
                "of the nonlinear residual, relative to the forces at work",
                Range{0, 1e-3, false});
    section.add("Geometry tolerance",
                of_geometry,
                "of that residual on surfaces as they are now, where Contact geometry is updated",
                Range{0, 1e-3, false});
    section.add(
      "Reduction",
      reduction,
      "of the residual by linear solves while the active set changes, relative to the loads (at most 1e-6 "
      "once a set has come up again, or after ten changes); the last one goes down to the Tolerance",
      Range{0, 1, false, false});
    section.add(
      "Stabilisation",
      stabilisation,
      "of motions that contact alone stops, in units of E times size, until it does; the result does not depend on it",
      positive);
    section.add_choice(
      "Undetermined motions",
      undetermined,
      {{"refuse", Undetermined::refuse}, {"hold", Undetermined::hold}},
      "of bodies that neither supports nor contact hold, as the rotation of a pin: refuse them, or hold them "
      "where that takes less than 1 % of the contact force");
  }



  std::string
  NewtonSettings::how_to_hold()
  {
    return "prescribe a displacement that does, or set Newton/Undetermined motions = hold, which "
           "holds it and reports the force that this takes";
  }
} // namespace Signorini
