// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/penalty_factor.h"

#include <signorini/parameters/section.h>

#include <cmath>
#include <limits>

namespace Signorini
{
  void
  PenaltyFactor::declare(Section &section, const std::string &help)
  {
    const double usual = factor;
    if (section.reading())
      factor = std::numeric_limits<double>::quiet_NaN();
    if (section.reading() || !is_absolute())
      section.add("Factor", factor, help, Range{0, 1e12, false});
    const bool is_set = !std::isnan(factor);
    if (!is_set)
      factor = usual;
    section.add(
      "Stiffness",
      stiffness,
      "penalty parameter (pressure over penetration) instead of a Factor; the result does not "
      "depend on the mesh then, as with contact stiffnesses of other programs; 0: none [force/length^3]",
      non_negative);
    if (section.reading() && is_set && is_absolute())
      section.fail("Stiffness", "is set together with Factor; set one of them");
  }
} // namespace Signorini
