// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/stretch_energy.h"

#include <utility>
#include <vector>

namespace Signorini
{
  /// Ogden's law, (6.8) of doc/theory: W = sum over terms of mu_p/alpha_p (l1^alpha_p + l2^alpha_p
  /// + l3^alpha_p - 3) - mu_p ln J, plus lambda/2 (ln J)^2; mu = sum mu_p alpha_p/2.
  class Ogden : public StretchEnergy
  {
  public:
    /// @param lambda Lame's first modulus [stress]
    /// @param terms pairs (mu_p [stress], alpha_p)
    Ogden(double lambda, std::vector<std::pair<double, double>> terms);

  protected:
    Derivatives
    derivatives(const std::array<double, 3> &log_stretches) const override;

  private:
    const double                                 lambda;
    const std::vector<std::pair<double, double>> terms;
  };
} // namespace Signorini
