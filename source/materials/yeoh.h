// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/invariant_energy.h"

namespace Signorini
{
  /// W = c10 i + c20 i^2 + c30 i^3 + K/2 (ln J)^2 with i = J^(-2/3) I1 - 3, which does not know
  /// the volume; mu = 2 c10. The volume's part is the one that mixed bodies have.
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
