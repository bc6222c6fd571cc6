// SPDX-License-Identifier: Apache-2.0
#include "materials/stored_energies.h"

#include <cmath>

namespace Signorini
{
  NeoHooke::NeoHooke(const double lambda, const double mu)
    : lambda(lambda)
    , mu(mu)
  {}



  // First and second derivatives of (6.8) by I1 and J; the energy does not depend on I2.
  InvariantEnergy::Derivatives
  NeoHooke::derivatives(const double I1, const double /*I2*/, const double J) const
  {
    const double log = std::log(J);
    Derivatives  w;
    w.value        = mu / 2 * (I1 - 3) - mu * log + lambda / 2 * log * log;
    w.first        = {{mu / 2, 0, (lambda * log - mu) / J}};
    w.second[2][2] = (lambda + mu - lambda * log) / (J * J);
    return w;
  }
} // namespace Signorini
