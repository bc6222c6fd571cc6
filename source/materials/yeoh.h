// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/invariant_energy.h"

namespace Signorini
{
  /// Yeoh's law, (6.8) of doc/theory: W = c10 i + c20 i^2 + c30 i^3 + K/2 (ln J)^2 with i =
  /// J^(-2/3) I1 - 3, which does not depend on the change of volume; mu = 2 c10. The volumetric
  /// energy has the same form as in the displacement-pressure formulation.
  class Yeoh : public InvariantEnergy
  {
  public:
    Yeoh(double bulk_modulus, double c10, double c20, double c30);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double K, c10, c20, c30;
  };
} // namespace Signorini
