// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_space.h"
#include "multigrid/level.h"
#include "solid/node_positions.h"

#include <vector>

namespace Signorini
{
  /// The coarse levels of a stiffness K of degree one by interpolation from regular grids of about
  /// twice, four times, … the distance of nodes, which need not fit the mesh (Xu, Computing 56
  /// (1996) 215-235; doc/theory, 7.1). From finer to coarser, as matrices P^T K P; none if K is
  /// small, or if the grids would not have much fewer nodes. Where nodes are closer than elsewhere,
  /// so are those of the grid, by powers of two. A grid node has unknowns for each part of a body
  /// within its cells, so that no level connects the sides of a slit, or two bodies. Collective.
  Spaces
  auxiliary_grids(const LA::SparseMatrix &K, const NodePositions &nodes);

  /// The levels of the stiffness of cells, which need not be assembled.
  Spaces
  auxiliary_grids(const CellSpace &space, const NodePositions &nodes);

  /// Append a space as the last one, with grids below it if there are any, otherwise with its
  /// matrix. Collective. @param P prolongation to the level above
  void
  append_last(Spaces                             &spaces,
              std::unique_ptr<const Prolongation> P,
              const CellSpace                    &space,
              const NodePositions                &nodes);

  /// The same for a space with a matrix.
  void
  append_last(Spaces                             &spaces,
              std::unique_ptr<const Prolongation> P,
              LA::SparseMatrix                  &&matrix,
              const NodePositions                &nodes);
} // namespace Signorini
