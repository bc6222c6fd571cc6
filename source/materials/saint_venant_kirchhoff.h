// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"

namespace Signorini
{
  /// Saint Venant-Kirchhoff's law, linear elasticity of the Green strain E = (C - I)/2: W =
  /// lambda/2 (tr E)^2 + mu E:E, (6.8) of doc/theory. Its tangent is indefinite in strong
  /// compression: along one axis from a stretch of 1/sqrt(3) on.
  class SaintVenantKirchhoff : public Hyperelastic
  {
  public:
    SaintVenantKirchhoff(double lambda, double mu);

    ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const override;

  private:
    const double lambda, mu;
  };
} // namespace Signorini
