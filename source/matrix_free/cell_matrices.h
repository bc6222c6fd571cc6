// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"

#include <deal.II/lac/full_matrix.h>

namespace Signorini
{
  /// The stiffness matrices of some cells by their kernel: column by column, of all cells at a
  /// time, as if they had no nodes in common.
  class CellMatrices
  {
  public:
    /// @param which numbers among the cells
    CellMatrices(const KernelCells &cells, const std::vector<unsigned int> &which);

    /// Of the k-th of them, with three components a node: row 3 i + c is that of component c of
    /// node i.
    dealii::FullMatrix<double>
    matrix(unsigned int k) const;

  private:
    const unsigned int               n_dofs;  ///< of a cell
    std::vector<std::vector<double>> columns; ///< [column][cell, row]
  };
} // namespace Signorini
