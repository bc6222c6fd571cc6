// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "multigrid/level.h"
#include "solid/stiffness.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// The levels of a multigrid method for the stiffness of bodies. Belongs to the mesh; no level
  /// joins nodes of two bodies.
  ///
  /// Below the stiffness itself there may be spaces of lower degree and on coarser meshes
  /// (`multigrid/`). Below the last of them come those of smoothed aggregation, made by ML from the
  /// near-null-space, the rigid-body modes: translations alone cost half as many again, and the
  /// count then grows with the mesh.
  class Hierarchy
  {
  public:
    /// Keeps a reference to the stiffness. Without spaces, its matrix is assembled.
    /// @param spaces from finer to coarser, the last one with a matrix
    /// @param modes rigid-body modes of the last space, or of the stiffness, on the locally owned
    /// degrees of freedom, mode by mode
    /// @param n_components unknowns of a node
    Hierarchy(const Stiffness                        &stiffness,
              std::vector<Level>                      spaces,
              const std::vector<std::vector<double>> &modes,
              unsigned int                            n_components);

    /// The number of levels, the finest one included.
    unsigned int
    n_levels() const
    {
      return 1 + coarse.size();
    }

    /// The stiffness of a level for its smoother. Level 0 is the finest, the present stiffness
    /// itself; the others are of the stiffness for which the hierarchy was made.
    const StiffnessOperator<float> &
    stiffness(const unsigned int level) const
    {
      return level == 0 ? fine.single_precision() : *coarse[level - 1].stiffness;
    }

    /// The number of unknowns of a node.
    unsigned int
    n_components() const
    {
      return my_n_components;
    }

    /// The matrix of the coarsest level, without contact stiffness, for its factorisation.
    const LA::SparseMatrix &
    coarsest_matrix() const
    {
      return *coarsest;
    }

    /// The prolongation from level + 1 to level.
    const Prolongation &
    prolongation(const unsigned int level) const
    {
      return *coarse[level].prolongation;
    }

    /// The degree of the Chebyshev polynomials that smooth a level. A space of lower degree
    /// approximates smooth error less well than aggregates do: where the degree falls, CG takes 13,
    /// 9, 8 and 7 iterations with 2, 3, 4 and 5, and 3 is the fastest.
    unsigned int
    smoothing_degree(const unsigned int level) const
    {
      return level < n_spaces ? 3 : 2;
    }

    /// The number of visits to a level in each cycle of the level above: a W-cycle over grids and
    /// aggregates, which have matrices, are less accurate, and much smaller from level to level; a
    /// V-cycle over meshes, where refinement may make many levels that hardly shrink.
    unsigned int
    n_visits(const unsigned int level) const
    {
      constexpr unsigned int much = 3;
      if (level > 0 && coarse[level - 1].matrix)
        return much * size(level) < size(level - 1) ? 2 : 1;
      return 1;
    }

  private:
    /// The number of unknowns of a level.
    dealii::types::global_dof_index
    size(const unsigned int level) const
    {
      return level == 0 ? fine.size() : coarse[level - 1].stiffness->owned().size();
    }

    const Stiffness        &fine;
    std::vector<Level>      coarse;
    const unsigned int      n_spaces, my_n_components;
    const LA::SparseMatrix *coarsest;
  };
} // namespace Signorini
