// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/invariant_energy.h"

namespace Signorini
{
  /// Rivlin's series for rubber in the form of Abaqus and CalculiX, up to the third power of the
  /// first invariant: W = c10 i1 + c01 i2 + c20 i1^2 + c30 i1^3 + K/2 (J - 1)^2, i1 = J^(-2/3) I1 -
  /// 3, i2 = J^(-4/3) I2 - 3 (CalculiX 2.20 manual, 6.8.3, where K = 2/D1); see (6.8) of
  /// doc/theory.
  class Polynomial : public InvariantEnergy
  {
  public:
    Polynomial(double bulk_modulus, double c10, double c01, double c20, double c30);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double K, c10, c01, c20, c30;
  };
} // namespace Signorini
