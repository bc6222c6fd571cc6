// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/galerkin_product.h"
#include "matrix_free/cell_space.h"

#include <functional>

namespace Signorini
{
  /// The cells of a space with their constraints condensed: each couples its free nodes, and those
  /// on which the others depend. Refers to the space.
  class CondensedCells
  {
  public:
    explicit CondensedCells(const CellSpace &space);

    /// The nodes of each cell.
    const LA::NodeSets &
    nodes() const
    {
      return sets;
    }

    /// Add P^T K P. @param graph of nodes()
    void
    add_to(LA::GalerkinProduct &product, const LA::NodeGraph &graph) const;

  private:
    /// True if an unknown of a cell depends on others.
    bool
    is_dependent(const KernelCells &cells, unsigned int cell) const;
    /// The matrix of a cell for the nodes of a set. @param matrix for those of the cell
    dealii::FullMatrix<double>
    condense(const KernelCells                &cells,
             unsigned int                      cell,
             std::size_t                       set,
             const dealii::FullMatrix<double> &matrix) const;

    static constexpr unsigned int dim = 3;

    const CellSpace &space;
    LA::NodeSets     sets;
  };
} // namespace Signorini
