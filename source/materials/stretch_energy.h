// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/hyperelastic.h"

#include <array>

namespace Signorini
{
  /// W of the principal stretches l1, l2, l3, by their logarithms e = ln l; equal ones included.
  class StretchEnergy : public Hyperelastic
  {
  public:
    struct Derivatives
    {
      double                               value = 0;
      std::array<double, 3>                first{};  ///< dW/de: the principal Kirchhoff stresses
      std::array<std::array<double, 3>, 3> second{}; ///< symmetric
    };

    ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const override;

  protected:
    virtual Derivatives
    derivatives(const std::array<double, 3> &log_stretches) const = 0;
  };
} // namespace Signorini
