#pragma once

#include <signorini/linear_algebra/direct_solver.h>
#include <signorini/solve/preconditioners/amg_springs.h>

#include <memory>
#include <optional>
#include <vector>

namespace Signorini
{
  /// A W-cycle for K + B^T D B with springs D that change: the levels are those of K, whose
  /// aggregates do not join bodies, so that their nodes slide freely on all levels; but the springs
  /// act on all of them.
  class AMG
  {
  public:
    /// @param contact null: no springs
    AMG(const Hierarchy &hierarchy, const GapOperator *contact);

    /// The springs D have changed, see AMGSprings::set. No level is made anew.
    void
    set_springs(const LA::Vector &values);

    /// One multigrid cycle.
    void
    vmult(LA::Vector &dst, const LA::Vector &src) const;

    unsigned int
    multigrid_cycles() const
    {
      return n_cycles;
    }

  private:
    struct Level
    {
      unsigned int             number; ///< 0: the finest
      const StiffnessOperator *K;
      const Prolongation      *P = nullptr;      ///< from the next level to this
      unsigned int             smoothing_degree; ///< of Chebyshev's polynomial
      unsigned int             n_visits;         ///< in a cycle of the level above
      LA::Vector               diagonal_K;
      LA::Vector               inverse_diagonal;       ///< of K + B^T D B
      double                   largest_eigenvalue = 0; ///< of inverse_diagonal * (K + B^T D B)
      mutable LA::Vector       x, right, rest, step, first;
    };

    void
    update();
    void
    update_diagonal(Level &level);
    void
    estimate_eigenvalue(Level &level);
    void
    factorise();

    void
    multiply(const Level &level, LA::Vector &dst, const LA::Vector &src) const;
    void
    smooth(const Level &level, LA::Vector &x, const LA::Vector &right, bool from_zero) const;
    void
    cycle(unsigned int l, LA::Vector &x, const LA::Vector &right) const;

    std::vector<std::unique_ptr<Level>> levels;
    std::optional<AMGSprings>           springs;
    const LA::SparseMatrix             &coarsest_K;
    std::unique_ptr<LA::SparseMatrix>   coarsest; ///< with springs; null: there are none
    LA::DirectSolver                    direct;   ///< of the coarsest level
    mutable unsigned int                n_cycles = 0;
  };
} // namespace Signorini
