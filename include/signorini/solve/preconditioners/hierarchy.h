#pragma once

#include <signorini/elasticity/stiffness.h>
#include <signorini/levels/degree_level.h>
#include <signorini/linear_algebra/smoothed_aggregation.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// The levels of a multigrid method for the stiffness of bodies. Belongs to the mesh; no level
  /// joins nodes of two bodies.
  ///
  /// Below the stiffness itself, or below a level of degree one on the same mesh, there are those
  /// of smoothed aggregation, made by ML from the near-null-space, the rigid-body modes:
  /// translations alone cost half as many again, and the count then grows with the mesh.
  class Hierarchy
  {
  public:
    /// Refers to the stiffness, whose matrix it asks for.
    /// @param modes rigid-body modes on the locally owned degrees of freedom, mode by mode
    /// @param n_components unknowns of a node
    Hierarchy(const Stiffness                        &stiffness,
              const std::vector<std::vector<double>> &modes,
              unsigned int                            n_components);

    /// Refers to the stiffness, which needs no matrix.
    Hierarchy(const Stiffness &stiffness, DegreeLevel level, unsigned int n_components);

    unsigned int
    n_levels() const
    {
      return 1 + coarse.size();
    }

    /// Level 0 is the finest, the stiffness itself, as a preconditioner needs it.
    const Stiffness &
    stiffness(const unsigned int level) const
    {
      return level == 0 ? finest : coarse[level - 1]->stiffness;
    }

    /// Of polynomials that smooth a level. Where the degree of displacements falls, the next level
    /// knows less of what is smooth: with 2, 3, 4 and 5, CG takes 13, 9, 8 and 7 iterations there,
    /// and 3 is quickest.
    unsigned int
    smoothing_degree(const unsigned int level) const
    {
      return level < n_degree_levels ? 3 : 2;
    }

    /// From level + 1 to level.
    const LA::SparseMatrix &
    prolongation(const unsigned int level) const
    {
      return coarse[level]->prolongation;
    }

  private:
    struct Level
    {
      Level(LA::SparseMatrix &&matrix, LA::SparseMatrix &&prolongation)
        : matrix(std::move(matrix))
        , prolongation(std::move(prolongation))
        , stiffness(this->matrix)
      {}

      const LA::SparseMatrix   matrix, prolongation;
      const AssembledStiffness stiffness; ///< refers to the matrix
    };

    void
    add_aggregates(const LA::SparseMatrix                 &matrix,
                   const std::vector<std::vector<double>> &modes,
                   unsigned int                            n_components);

    const Stiffness                    &finest;
    unsigned int                        n_degree_levels = 0; ///< above the one of degree one
    std::vector<std::unique_ptr<Level>> coarse;
  };
} // namespace Signorini
