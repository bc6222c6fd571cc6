// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_kernel.h"
#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// A space of displacements in three dimensions as cell kernels need it: cells, degrees of
  /// freedom and constraints, of the finest mesh or of a coarser level.
  struct CellSpace
  {
    /// The degrees of freedom of this rank, those of rigid bodies last.
    dealii::IndexSet owned;
    /// The cells of this rank, one entry for each degree; nodes by the global index of their first
    /// component.
    std::vector<KernelCells> cells;
    /// The constraints of all degrees of freedom of these cells.
    dealii::AffineConstraints<double> constraints;
    /// Diagonal terms of K beyond the stiffness of cells [force/length].
    LA::Vector diagonal_terms;
    MPI_Comm   comm;
  };

  /// The space of the bodies on the present mesh; the cells of each degree are in the order of the
  /// mesh.
  CellSpace
  cell_space(const Elasticity<3> &elasticity);

  /// cell_space() without node positions and moduli.
  CellSpace
  bare_cell_space(const Elasticity<3> &elasticity);

  /// Assemble K. Collective.
  void
  assemble(const CellSpace &space, LA::SparseMatrix &K);
} // namespace Signorini
