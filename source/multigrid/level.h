// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "multigrid/prolongation.h"
#include "solid/node_positions.h"
#include "solid/stiffness.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// A multigrid level below another one: its operator, and the prolongation to the next finer
  /// level.
  struct Level
  {
    /// A level with an assembled stiffness.
    Level(std::unique_ptr<const Prolongation> prolongation, LA::SparseMatrix &&assembled)
      : prolongation(std::move(prolongation))
      , matrix(std::make_unique<LA::SparseMatrix>(std::move(assembled)))
      , stiffness(std::make_unique<AssembledOperator>(*matrix))
    {}

    /// A level of which only products are available.
    Level(std::unique_ptr<const Prolongation>             prolongation,
          std::unique_ptr<const StiffnessOperator<float>> stiffness)
      : prolongation(std::move(prolongation))
      , stiffness(std::move(stiffness))
    {}

    std::unique_ptr<const Prolongation>     prolongation; ///< from this level to the one above
    std::unique_ptr<const LA::SparseMatrix> matrix;       ///< null: there is none
    /// The operator; refers to the matrix if there is one.
    std::unique_ptr<const StiffnessOperator<float>> stiffness;
  };

  /// The geometric levels below the stiffness of the bodies: spaces of displacements.
  struct Spaces
  {
    std::vector<Level> levels; ///< from finer to coarser; the last has a matrix
    NodePositions      nodes;  ///< of the last one
  };
} // namespace Signorini
