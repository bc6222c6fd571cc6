// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace Signorini
{
  /// The tangent of a cell or an integration point in space, the change of forces with gradients,
  /// both in reference coordinates of the cell: D_(c d)(e f) = w dxi_d/dX_J (dP_cJ/dF_eL)
  /// dxi_f/dX_L, with the weight w. It is symmetric; stored are the entries on and below the
  /// diagonal, row by row, where row 3 c + d belongs to component c and direction d.
  constexpr unsigned int n_tangent_components = 9, n_tangent_numbers = 45;

  /// The position of an entry among the stored numbers.
  constexpr unsigned int
  tangent_number(const unsigned int row, const unsigned int column)
  {
    return row >= column ? row * (row + 1) / 2 + column : column * (column + 1) / 2 + row;
  }

  /// Stored in single precision, which suffices for tangents.
  using CellTangent = std::array<float, n_tangent_numbers>;

  /// The tangents of the cells of this rank, by active cell index, integrated over each cell.
  using CellTangents = std::vector<CellTangent>;
} // namespace Signorini
