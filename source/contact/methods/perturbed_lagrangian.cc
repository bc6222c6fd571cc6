#include "contact/methods/perturbed_lagrangian.h"

#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  PerturbedLagrangian::declare(Section &section)
  {
    penalty_factor.declare(
      section, "stiffness of the contact in units of E/h: the penetration is p h / (Factor E)");
    section.add_choice("Form",
                       form,
                       {{"block", Form::block}, {"condensed", Form::condensed}},
                       "keep the pressure as an unknown, or eliminate it");
  }
} // namespace Signorini
