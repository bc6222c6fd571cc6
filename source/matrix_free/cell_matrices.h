// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"

#include <deal.II/lac/full_matrix.h>

namespace Signorini
{
  /// The stiffness matrices of some cells by their kernel: one column of all of them at a time, by
  /// a product in which the cells share no nodes.
  class CellMatrices
  {
  public:
    /// @param which numbers among the cells
    CellMatrices(const KernelCells &cells, const std::vector<unsigned int> &which);

    /// The matrix of the k-th selected cell; row 3 i + c belongs to component c of node i.
    dealii::FullMatrix<double>
    matrix(unsigned int k) const;

  private:
    /// Degrees of freedom of each cell.
    const unsigned int               n_dofs;
    std::vector<std::vector<double>> columns; ///< [column][cell, row]
  };
} // namespace Signorini
