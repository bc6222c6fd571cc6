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
    /// Refers to the stiffness. Without spaces, asks for its matrix.
    /// @param spaces from finer to coarser, the last one with a matrix
    /// @param modes rigid-body modes of the last of them, or of the stiffness, on the locally owned
    /// degrees of freedom, mode by mode
    /// @param n_components unknowns of a node
    Hierarchy(const Stiffness                        &stiffness,
              std::vector<Level>                      spaces,
              const std::vector<std::vector<double>> &modes,
              unsigned int                            n_components);

    unsigned int
    n_levels() const
    {
      return 1 + coarse.size();
    }

    /// Level 0 is the finest, the stiffness itself as it is now, as a preconditioner needs it; the
    /// others are of what it was when they were made.
    const StiffnessOperator<float> &
    stiffness(const unsigned int level) const
    {
      return level == 0 ? fine.single_precision() : *coarse[level - 1].stiffness;
    }

    /// Unknowns of a node.
    unsigned int
    n_components() const
    {
      return my_n_components;
    }

    const LA::SparseMatrix &
    coarsest_matrix() const
    {
      return *coarsest;
    }

    /// From level + 1 to level.
    const Prolongation &
    prolongation(const unsigned int level) const
    {
      return *coarse[level].prolongation;
    }

    /// Of polynomials that smooth a level. A space below knows less of what is smooth than
    /// aggregates do: where the degree falls, CG takes 13, 9, 8 and 7 iterations with 2, 3, 4 and
    /// 5, and 3 is the quickest.
    unsigned int
    smoothing_degree(const unsigned int level) const
    {
      return level < n_spaces ? 3 : 2;
    }

    /// Of each cycle above it: a W-cycle over aggregates, which are not as good, but there are few
    /// levels of them; a V-cycle over meshes, where refinement may make many that hardly shrink.
    unsigned int
    n_visits(const unsigned int level) const
    {
      return level < n_spaces ? 1 : 2;
    }

  private:
    const Stiffness        &fine;
    std::vector<Level>      coarse;
    const unsigned int      n_spaces, my_n_components;
    const LA::SparseMatrix *coarsest;
  };
} // namespace Signorini
