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
    /// The nodes on which unknowns of a cell depend, with repetitions; none if they are many: a
    /// preconditioner may do without them.
    std::vector<dealii::types::global_dof_index>
    masters(const KernelCells &cells, unsigned int cell) const;
    /// The matrix of a cell for the nodes of a set. @param matrix for those of the cell
    dealii::FullMatrix<double>
    condense(const KernelCells                &cells,
             unsigned int                      cell,
             std::size_t                       set,
             const dealii::FullMatrix<double> &matrix) const;

    static constexpr unsigned int dim = 3;

    const CellSpace  &space;
    LA::NodeSets      sets;
    std::vector<bool> is_dependent; ///< of sets: with nodes on which unknowns depend
  };
} // namespace Signorini
