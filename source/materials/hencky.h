// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/stretch_energy.h"

namespace Signorini
{
  /// Hencky's law, (6.8) of doc/theory: linear elasticity of the logarithmic strains, W = mu (e1^2
  /// + e2^2 + e3^2) + lambda/2 (e1 + e2 + e3)^2.
  class Hencky : public StretchEnergy
  {
  public:
    Hencky(double lambda, double mu);

  protected:
    Derivatives
    derivatives(const std::array<double, 3> &log_stretches) const override;

  private:
    const double lambda, mu;
  };
} // namespace Signorini
