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
    dealii::IndexSet                  owned; ///< degrees of freedom, those of rigid bodies last
    std::vector<KernelCells>          cells; ///< of this rank, one a degree; nodes by global index
    dealii::AffineConstraints<double> constraints; ///< of all that these cells touch
    LA::Vector diagonal_terms; ///< what K has on its diagonal beyond the stiffness of cells
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
