// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>

namespace Signorini
{
  /// Orthonormal vectors across a unit vector n; in space, n is their cross product.
  template <int dim>
  std::array<dealii::Tensor<1, dim>, dim - 1>
  vectors_across(const dealii::Tensor<1, dim> &n)
  {
    if constexpr (dim == 2)
      return {{cross_product_2d(n)}};
    else
      {
        // Of axes that are as little along the normal as others up to rounding, the first one.
        unsigned int least = 0;
        for (unsigned int d = 1; d < 3; ++d)
          if (std::abs(n[d]) < std::abs(n[least]) - 1e-6)
            least = d;
        dealii::Tensor<1, 3> axis;
        axis[least]                       = 1;
        const dealii::Tensor<1, 3> across = cross_product_3d(n, axis);
        const dealii::Tensor<1, 3> first  = across / across.norm();
        return {{first, cross_product_3d(n, first)}};
      }
  }
} // namespace Signorini
