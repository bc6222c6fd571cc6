// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace Signorini
{
  /// Of a cell or a point in three dimensions: what its forces change by with its gradients, both
  /// in unit coordinates, D_(c d)(e f) = w dxi_d/dX_J (dP_cJ/dF_eL) dxi_f/dX_L with its weight w,
  /// symmetric: on and below the diagonal, row 3 c + d by row.
  constexpr unsigned int n_tangent_components = 9, n_tangent_numbers = 45;

  constexpr unsigned int
  tangent_number(const unsigned int row, const unsigned int column)
  {
    return row >= column ? row * (row + 1) / 2 + column : column * (column + 1) / 2 + row;
  }

  using CellTangent = std::array<float, n_tangent_numbers>;

  /// The tangents of the cells of this rank, by active cell index, integrated over each cell.
  using CellTangents = std::vector<CellTangent>;
} // namespace Signorini
