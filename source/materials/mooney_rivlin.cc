// SPDX-License-Identifier: Apache-2.0
#include "materials/stored_energies.h"

#include <cmath>

namespace Signorini
{
  MooneyRivlin::MooneyRivlin(const double lambda, const double c10, const double c01)
    : lambda(lambda)
    , c10(c10)
    , c01(c01)
  {}



  // The terms in ln J make the reference configuration free of stress with the modulus lambda.
  InvariantEnergy::Derivatives
  MooneyRivlin::derivatives(const double I1, const double I2, const double J) const
  {
    const double log = std::log(J), at_rest = 2 * c10 + 4 * c01, of_volume = lambda - 4 * c01;
    Derivatives  w;
    w.value        = c10 * (I1 - 3) + c01 * (I2 - 3) - at_rest * log + of_volume / 2 * log * log;
    w.first        = {{c10, c01, (of_volume * log - at_rest) / J}};
    w.second[2][2] = (of_volume + at_rest - of_volume * log) / (J * J);
    return w;
  }
} // namespace Signorini
