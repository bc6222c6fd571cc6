// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/lagrange_multiplier.h"

#include <signorini/parameters/section.h>

namespace Signorini
{
  void
  LagrangeMultiplier::declare(Section &section)
  {
    section.add(
      "Complementarity factor",
      complementarity_factor,
      "factor of the gap, in units of E/h, in the complementarity function p - c g of the active-set "
      "strategy; the result does not depend on it",
      positive);
  }
} // namespace Signorini
