// SPDX-License-Identifier: Apache-2.0
#include "materials/stored_energies.h"

namespace Signorini
{
  Hencky::Hencky(const double lambda, const double mu)
    : lambda(lambda)
    , mu(mu)
  {}



  // In the logarithmic stretches the energy is that of linear elasticity.
  StretchEnergy::Derivatives
  Hencky::derivatives(const std::array<double, 3> &e) const
  {
    const double volume = e[0] + e[1] + e[2];
    Derivatives  w;
    w.value = lambda / 2 * volume * volume;
    for (unsigned int a = 0; a < 3; ++a)
      {
        w.value += mu * e[a] * e[a];
        w.first[a] = lambda * volume + 2 * mu * e[a];
        w.second[a].fill(lambda);
        w.second[a][a] += 2 * mu;
      }
    return w;
  }
} // namespace Signorini
