#pragma once

#include <signorini/linear_algebra/smoothed_aggregation.h>

#include <vector>

namespace Signorini
{
  /// The levels of a smoothed-aggregation multigrid method for the stiffness matrix, made by ML
  /// from its near-null-space, the rigid-body modes: translations alone cost half as many again,
  /// and the count then grows with the mesh. Belongs to the mesh; aggregates never contain nodes of
  /// two bodies.
  class Hierarchy
  {
  public:
    /// @param modes rigid-body modes on the locally owned degrees of freedom, mode by mode
    Hierarchy(const LA::SparseMatrix                 &stiffness,
              const std::vector<std::vector<double>> &modes,
              const unsigned int                      dim)
      : stiffness(stiffness)
      , coarse(LA::smoothed_aggregation(stiffness, modes, dim))
    {}

    unsigned int
    n_levels() const
    {
      return 1 + coarse.size();
    }

    /// Level 0 is the finest, the stiffness matrix itself; the others are its Galerkin products.
    const LA::SparseMatrix &
    matrix(const unsigned int level) const
    {
      return level == 0 ? stiffness : coarse[level - 1].matrix;
    }

    /// From level + 1 to level.
    const LA::SparseMatrix &
    prolongation(const unsigned int level) const
    {
      return coarse[level].prolongation;
    }

  private:
    const LA::SparseMatrix            &stiffness;
    const std::vector<LA::CoarseLevel> coarse;
  };
} // namespace Signorini
