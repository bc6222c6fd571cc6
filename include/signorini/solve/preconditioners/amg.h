#pragma once

#include <signorini/contact/discretisation/gap_operator.h>
#include <signorini/solve/preconditioners/hierarchy.h>

class Amesos_BaseSolver;
class Epetra_LinearProblem;

namespace Signorini
{
  /// A W-cycle for K + B^T D B with springs D that change: the levels are those of K, whose
  /// aggregates do not join bodies, so that their nodes slide freely on all levels; but the springs
  /// act on all of them, as B P_1 P_2 ... to the left and right of D. Without them, the corrections
  /// of bodies that touch would know nothing of each other. Points between the same two faces share
  /// a spring.
  class AMG
  {
  public:
    /// @param contact null: no springs
    AMG(const Hierarchy &hierarchy, const GapOperator *contact);

    ~AMG();

    /// The springs D have changed. No level is made anew. Those stiffer than 6 k W, which between
    /// equal bodies is three times E/h, count as that: they couple the bodies well enough, and
    /// larger ones would slow down the smoothers (of 1, 3, 10, 100 and 1000 times E/h this took the
    /// fewest iterations).
    void
    set_springs(const LA::Vector &springs);

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
      const Epetra_CrsMatrix *K, *P = nullptr; ///< P: from the next level to this
      /// Of the springs.
      std::shared_ptr<const Epetra_CrsMatrix> B;
      LA::Vector                              diagonal_K;
      LA::Vector                              inverse_diagonal; ///< of K + B^T D B
      double             largest_eigenvalue = 0; ///< of inverse_diagonal * (K + B^T D B)
      mutable LA::Vector x, right, rest, step, first, force, gap;
    };

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

    std::vector<std::unique_ptr<Level>>   levels;
    std::vector<unsigned int>             groups; ///< spring of each local contact point
    LA::Vector                            D, limit;
    bool                                  has_springs;
    std::unique_ptr<Epetra_CrsMatrix>     coarsest;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver>    direct; ///< looks at coarsest and problem
    mutable unsigned int                  n_cycles = 0;
  };
} // namespace Signorini
