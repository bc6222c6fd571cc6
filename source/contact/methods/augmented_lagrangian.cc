// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/augmented_lagrangian.h"

#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  AugmentedLagrangian::declare(Section &section)
  {
    penalty_factor.declare(
      section,
      "penalty parameter in units of E/h; a larger one needs fewer augmentations, the result does not depend on it");
    section.rename_key("Loop", "Scheme");
    section.add_choice(
      "Scheme",
      loop,
      {{"Uzawa", Loop::Uzawa}, {"Newton", Loop::Newton}},
      "Uzawa: a sequence of penalty solutions with updates of the multiplier; Newton: displacement and multiplier are solved simultaneously");
  }
} // namespace Signorini
