// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"

#include <array>

namespace Signorini
{
  /// An energy that is a function of I1 = tr C, I2 = ((tr C)^2 - tr C^2)/2 and J = sqrt(det C), in
  /// this order; see (6.6) of doc/theory for stress and tangent.
  class InvariantEnergy : public Hyperelastic
  {
  public:
    /// W with its first and second derivatives by I1, I2, J.
    struct Derivatives
    {
      double                value = 0;
      std::array<double, 3> first{};
      /// Second derivatives, symmetric.
      std::array<std::array<double, 3>, 3> second{};
    };

    ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const override;

  protected:
    /// @return W and its derivatives, which each law defines.
    virtual Derivatives
    derivatives(double I1, double I2, double J) const = 0;
  };
} // namespace Signorini
