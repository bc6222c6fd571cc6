#include <signorini/contact/methods/penalty.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  Penalty::declare(Section &section)
  {
    section.add(
      "Factor",
      penalty_factor,
      "penalty in units of E/h: larger is more exact, the penetration is p h / (Factor E)",
      positive);
    section.add_choice("Weighting",
                       weighting,
                       {"mortar", "pointwise"},
                       "penalise the gap weighted at the slave nodes, or at each quadrature point");
  }
} // namespace Signorini
