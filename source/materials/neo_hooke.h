// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/invariant_energy.h"

namespace Signorini
{
  /// The neo-Hookean law, (6.8) of doc/theory: W = mu/2 (I1 - 3) - mu ln J + lambda/2 (ln J)^2
  /// (Bonet and Wood).
  class NeoHooke : public InvariantEnergy
  {
  public:
    NeoHooke(double lambda, double mu);

  protected:
    Derivatives
    derivatives(double I1, double I2, double J) const override;

  private:
    const double lambda, mu;
  };
} // namespace Signorini
