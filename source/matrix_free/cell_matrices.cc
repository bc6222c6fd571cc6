// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/cell_matrices.h"

namespace Signorini
{
  using namespace dealii;

  // Element matrices as products of the kernel with unit vectors: the cells are separated, so that
  // each has its own nodes, and one product yields column j of all their matrices.
  CellMatrices::CellMatrices(const KernelCells &cells, const std::vector<unsigned int> &which)
    : n_dofs(3 * cells.nodes_per_cell())
  {
    KernelCells apart;
    apart.degree         = cells.degree;
    apart.are_tetrahedra = cells.are_tetrahedra;
    for (const unsigned int cell : which)
      {
        for (unsigned int i = 0; i < n_dofs; i += 3)
          apart.nodes.push_back(n_dofs * apart.size() + i);
        // Geometry and moduli, or tangents, belong to the cell and are copied; nodes are new.
        const auto copy = [&](const auto &from, const std::size_t n, auto &to) {
          to.insert(to.end(), from.begin() + n * cell, from.begin() + n * (cell + 1));
        };
        if (cells.has_tangents())
          copy(cells.tangents, cells.tangents.size() / cells.size(), apart.tangents);
        else
          {
            copy(cells.points, n_dofs, apart.points);
            copy(cells.lambda, 1, apart.lambda);
            copy(cells.mu, 1, apart.mu);
          }
      }
    const auto          kernel = CellKernel<double>::create(apart);
    std::vector<double> u(std::size_t(n_dofs) * which.size(), 0.);
    columns.resize(n_dofs, u);
    // Set degree of freedom j of all cells to one, and all others to zero.
    for (unsigned int j = 0; j < n_dofs; ++j)
      {
        for (std::size_t at = j; at < u.size(); at += n_dofs)
          u[at] = 1;
        kernel->add_product(columns[j].data(), u.data());
        for (std::size_t at = j; at < u.size(); at += n_dofs)
          u[at] = 0;
      }
  }



  // Entry (i, j) of cell k is in column j at its i-th own degree of freedom.
  FullMatrix<double>
  CellMatrices::matrix(const unsigned int k) const
  {
    FullMatrix<double> result(n_dofs, n_dofs);
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j < n_dofs; ++j)
        result(i, j) = columns[j][std::size_t(n_dofs) * k + i];
    return result;
  }
} // namespace Signorini
