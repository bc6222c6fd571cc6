// SPDX-License-Identifier: Apache-2.0
#include "materials/stored_energies.h"

#include <cmath>

namespace Signorini
{
  Ogden::Ogden(const double lambda, std::vector<std::pair<double, double>> terms)
    : lambda(lambda)
    , terms(std::move(terms))
  {}



  // Each term is a sum over the three stretches, with l^alpha = exp(alpha e); -mu ln J is -mu times
  // the sum of the e.
  StretchEnergy::Derivatives
  Ogden::derivatives(const std::array<double, 3> &e) const
  {
    const double volume = e[0] + e[1] + e[2];
    Derivatives  w;
    w.value = lambda / 2 * volume * volume;
    for (unsigned int a = 0; a < 3; ++a)
      {
        w.first[a] = lambda * volume;
        w.second[a].fill(lambda);
        for (const auto &[mu, alpha] : terms)
          {
            const double power = std::exp(alpha * e[a]);
            w.value += mu / alpha * (power - 1) - mu * e[a];
            w.first[a] += mu * (power - 1);
            w.second[a][a] += mu * alpha * power;
          }
      }
    return w;
  }
} // namespace Signorini
