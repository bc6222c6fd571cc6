// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_space.h"
#include "multigrid/level.h"
#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// Displacements of degree one on the finest mesh. Refers to most of them.
  struct LinearDisplacements
  {
    const dealii::DoFHandler<3>             &dofs;
    const dealii::AffineConstraints<double> &hanging, &constraints;
    const dealii::IndexSet                  &owned;
    LA::Vector                               terms; ///< see CellSpace::diagonal_terms
    std::vector<std::vector<double>>         modes; ///< rigid-body modes
    const CellTangents *tangents; ///< of the cells; null: they are of materials at rest
  };

  /// Their space, for kernels.
  CellSpace
  finest_space(const LinearDisplacements &linear, const Elasticity<3> &elasticity);

  /// The same on the meshes that remain when the cells of the finest level are taken back to their
  /// parents, again and again: whatever was refined, each is a mesh of its own with hanging nodes
  /// (global coarsening: Munch, Heister, Prieto Saavedra, Kronbichler, ACM Trans. Parallel Comput.
  /// 10 (2023) 3). Vertices of a coarse cell are vertices of leaves: their degrees of freedom there
  /// name them on all levels, and constraints are the same wherever both are. Ends where a support
  /// would get lost, or where a factorisation is cheap; empty if there is nothing to take back.
  /// Collective.
  Spaces
  mesh_levels(const LinearDisplacements &linear, const Elasticity<3> &elasticity);
} // namespace Signorini
