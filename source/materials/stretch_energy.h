// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"

#include <array>

namespace Signorini
{
  /// An energy that is a symmetric function of the principal stretches l1, l2, l3, written with
  /// their logarithms e = ln l; stretches may be equal. See (6.7) of doc/theory for stress and
  /// tangent.
  class StretchEnergy : public Hyperelastic
  {
  public:
    /// W with its first and second derivatives by e1, e2, e3.
    struct Derivatives
    {
      double value = 0;
      /// dW/de, the principal Kirchhoff stresses.
      std::array<double, 3> first{};
      /// Second derivatives, symmetric.
      std::array<std::array<double, 3>, 3> second{};
    };

    ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const override;

  protected:
    /// @return W and its derivatives, which each law defines.
    virtual Derivatives
    derivatives(const std::array<double, 3> &log_stretches) const = 0;
  };
} // namespace Signorini
