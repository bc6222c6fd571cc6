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
      "weight of the gap, in units of E/h, where the active set is decided; the result does not depend on it",
      positive);
  }
} // namespace Signorini
