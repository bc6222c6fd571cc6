// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/invariant_energy.h"

namespace Signorini
{
  /// The Mooney-Rivlin law, (6.8) of doc/theory: W = c10 (I1 - 3) + c01 (I2 - 3) - (2 c10 + 4 c01)
  /// ln J + (lambda - 4 c01)/2 (ln J)^2, so that the reference configuration is free of stress and
  /// has the moduli lambda and mu = 2 (c10 + c01).
  class MooneyRivlin : public InvariantEnergy
  {
  public:
    MooneyRivlin(double lambda, double c10, double c01);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double lambda, c10, c01;
  };
} // namespace Signorini
