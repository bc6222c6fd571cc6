// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/tensor.h>

#include <array>

namespace Signorini
{
  /// @return the surface gradient of a function on a face, a tangential vector, by the inverse
  /// metric.
  /// @param tangents derivatives of the position by the parameters
  /// @param slope derivatives of the function by the parameters
  template <int dim>
  dealii::Tensor<1, dim>
  surface_gradient(const std::array<dealii::Tensor<1, dim>, dim - 1> &tangents,
                   const dealii::Tensor<1, dim - 1>                  &slope)
  {
    dealii::Tensor<2, dim - 1> metric;
    for (unsigned int d = 0; d < dim - 1; ++d)
      for (unsigned int e = 0; e < dim - 1; ++e)
        metric[d][e] = tangents[d] * tangents[e];
    const dealii::Tensor<1, dim - 1> raised = invert(metric) * slope;
    dealii::Tensor<1, dim>           gradient;
    for (unsigned int d = 0; d < dim - 1; ++d)
      gradient += raised[d] * tangents[d];
    return gradient;
  }
} // namespace Signorini
