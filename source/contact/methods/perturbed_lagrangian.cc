#include <signorini/contact/methods/perturbed_lagrangian.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  PerturbedLagrangian::declare(Section &section)
  {
    section.add("Factor",
                penalty_factor,
                "stiffness of the contact in units of E/h: the penetration is p h / (Factor E)",
                positive);
    section.add_choice("Form",
                       form,
                       {"block", "condensed"},
                       "keep the pressure as an unknown, or eliminate it");
  }
} // namespace Signorini
