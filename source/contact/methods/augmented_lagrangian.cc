#include "contact/methods/augmented_lagrangian.h"

#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  AugmentedLagrangian::declare(Section &section)
  {
    penalty_factor.declare(
      section,
      "penalty in units of E/h: larger needs fewer augmentations, the result does not depend on it");
    section.add_choice(
      "Loop",
      loop,
      {{"Uzawa", Loop::Uzawa}, {"Newton", Loop::Newton}},
      "penalty solutions one after the other; or displacement and pressure at once");
  }
} // namespace Signorini
