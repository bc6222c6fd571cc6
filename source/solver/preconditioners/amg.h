// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/direct_solver.h"
#include "solver/preconditioners/level_contact_stiffness.h"

#include <memory>
#include <optional>
#include <vector>

namespace Signorini
{
  /// A multigrid cycle for K + B^T D B with a contact stiffness D that changes. The levels are
  /// those of K, whose aggregates do not join bodies, so that bodies can slide freely on all
  /// levels; the contact stiffness acts on all of them (doc/theory, 7.1 and 7.2). Levels are in
  /// single precision; the coarsest one is factorised in double precision.
  class AMG
  {
  public:
    /// @param contact null: no contact stiffness; else set_contact_stiffness() has to be called
    /// before the first vmult()
    AMG(const Hierarchy &hierarchy, const GapOperator *contact);

    /// Set the contact stiffness D, see LevelContactStiffness::set(). No level is rebuilt.
    void
    set_contact_stiffness(const PointVectors &values);

    /// One multigrid cycle.
    void
    vmult(LA::Vector &dst, const LA::Vector &src) const;

    /// The number of cycles so far.
    unsigned int
    multigrid_cycles() const
    {
      return n_cycles;
    }

  private:
    /// Vectors are arrays of this rank's degrees of freedom.
    struct Level
    {
      unsigned int                    number; ///< 0: the finest
      const StiffnessOperator<float> *K;
      const Prolongation             *P = nullptr;      ///< from the next level to this
      unsigned int                    smoothing_degree; ///< of Chebyshev's polynomial
      unsigned int                    n_visits;         ///< in a cycle of the level above
      std::vector<float>              diagonal_K;
      std::vector<float>              inverse_diagonal;  ///< of K + B^T D B
      double                     largest_eigenvalue = 0; ///< of inverse_diagonal * (K + B^T D B)
      mutable std::vector<float> x, right, step, first;
    };

    /// Update diagonals and the factorisation after a change of the contact stiffness.
    void
    update();
    /// Set the inverse diagonal of K + B^T D B on a level.
    void
    update_diagonal(Level &level);
    /// Estimate the largest eigenvalue for the smoother of a level (doc/theory, (7.3)). Collective.
    void
    estimate_eigenvalue(Level &level);
    /// Factorise the matrix of the coarsest level, with contact stiffness. Collective.
    void
    factorise();

    /// (K + B^T D B) x; the array is valid until the next product. Collective.
    float *
    multiply(const Level &level, const float *x) const;
    /// right - (K + B^T D B) x of a level, in an array that is valid until the next product.
    /// Collective.
    float *
    residual(const Level &level) const;
    /// Apply the Chebyshev smoother to x. @param from_zero x is zero initially
    void
    smooth(const Level &level, bool from_zero) const;
    /// Solve on the coarsest level by its factors, in double precision. Collective.
    void
    solve_coarsest(const Level &level) const;
    /// One cycle for the right-hand side of level l; the result is its x.
    void
    cycle(unsigned int l) const;

    std::vector<std::unique_ptr<Level>>  levels;
    std::optional<LevelContactStiffness> contact_stiffness;
    const LA::SparseMatrix              &coarsest_K;
    std::unique_ptr<LA::SparseMatrix>    coarsest; ///< with contact stiffness; null: it is zero
    LA::DirectSolver                     direct;   ///< of the coarsest level
    mutable LA::Vector                   coarsest_x, coarsest_right;
    mutable unsigned int                 n_cycles = 0;
  };
} // namespace Signorini
