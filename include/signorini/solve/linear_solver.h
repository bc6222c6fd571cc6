#pragma once

#include <signorini/solve/linear_solver_settings.h>
#include <signorini/solve/preconditioner.h>

#include <deal.II/base/timer.h>

#include <stdexcept>

namespace Signorini
{
  /// The solution could not be found. All ranks throw it alike.
  class SolverFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// The multigrid hierarchy of a stiffness matrix, which outlives contact that is looked for
  /// again; null where the preconditioner needs none.
  /// @param modes rigid-body modes
  std::shared_ptr<const Hierarchy>
  make_hierarchy(const LinearSolverSettings             &settings,
                 const LA::SparseMatrix                 &stiffness,
                 const std::vector<std::vector<double>> &modes,
                 unsigned int                            dim);

  /// Solves the contact systems of one mesh. The multigrid hierarchy is built once; what changes
  /// with the active set is what the preconditioner keeps on the surface.
  class LinearSolver
  {
  public:
    /// @param hierarchy make_hierarchy()
    LinearSolver(const LinearSolverSettings      &settings,
                 const ContactSystem             &system,
                 std::shared_ptr<const Hierarchy> hierarchy,
                 unsigned int                     dim,
                 dealii::TimerOutput             &timer);

    /// The system's active set has changed.
    void
    update();

    /// Solve from a zero start until the residual has fallen by the reduction, or below the
    /// absolute tolerance. What the preconditioner's start achieves does not count as reduction: it
    /// takes away the forces of stiff penalties, next to which all others look small. Returns the
    /// number of iterations; throws SolverFailure. Where the contact filter does not get there and
    /// the system is not too large for it, it is factorised from then on.
    unsigned int
    solve(LA::BlockVector       &x,
          const LA::BlockVector &rhs,
          double                 reduction,
          double                 absolute_tolerance);

    unsigned int
    multigrid_cycles() const
    {
      return preconditioner->multigrid_cycles() + cycles_before;
    }

    /// True: the Krylov method did not converge, and the system is factorised instead.
    bool
    has_given_up() const
    {
      return has_given_up_iterating;
    }

  private:
    /// Returns the number of iterations; throws SolverFailure.
    unsigned int
    iterate(const std::string     &krylov,
            double                 tolerance,
            LA::BlockVector       &x,
            const LA::BlockVector &rhs);

    void
    make_preconditioner();
    bool
    can_factorise() const;

    LinearSolverSettings             settings;
    const ContactSystem             &system;
    const unsigned int               dim;
    dealii::TimerOutput             &timer;
    std::shared_ptr<const Hierarchy> hierarchy;
    std::unique_ptr<Preconditioner>  preconditioner;
    bool                             has_given_up_iterating = false;
    unsigned int                     cycles_before          = 0; ///< giving up
  };
} // namespace Signorini
