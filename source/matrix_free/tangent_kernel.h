// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"

namespace Signorini
{
  /// A kernel for cells that have tangents, which are in single precision: what a Newton step lacks
  /// by that is less than it is solved to. With one tangent a cell it makes use of Legendre's
  /// polynomials, and needs fewer operations than isotropic elasticity does, since the geometry is
  /// in the tangent; with one a point it is exact. Parameters as CellKernel::create() has them.
  template <typename Number>
  std::unique_ptr<CellKernel<Number>>
  make_tangent_kernel(const KernelCells &cells, const std::string &instruction_set);
} // namespace Signorini
