// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"

namespace Signorini
{
  /// A kernel for cells with tangents, which are stored in single precision: their rounding is far
  /// below the accuracy of a Newton step. With one tangent for each cell it uses Legendre
  /// polynomials, and fewer operations than isotropic elasticity, since the geometry is in the
  /// tangent; with one for each point it is the exact tangent. Parameters as of
  /// CellKernel::create().
  template <typename Number>
  std::unique_ptr<CellKernel<Number>>
  make_tangent_kernel(const KernelCells &cells, const std::string &instruction_set);
} // namespace Signorini
