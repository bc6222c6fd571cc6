// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/solver_failure.h"
#include "solver/preconditioner.h"
#include "solver/solid_hierarchy.h"

#include <deal.II/base/timer.h>
#include <deal.II/lac/solver_control.h>

#include <functional>
#include <memory>

namespace Signorini
{
  /// What CG does where it meets a direction along which the system is not positive.
  enum class NegativeCurvature
  {
    ignore,
    report,  ///< throws IndefiniteSystem
    reject,  ///< likewise, also if it takes so many iterations that one cannot be far
    truncate ///< with what it had before (Steihaug, SIAM J. Numer. Anal. 20 (1983) 626), likewise
  };

  /// Solves the contact systems of one mesh. Rebuilds as much as has changed: with the active set,
  /// what the preconditioner keeps on the surface; with the values of the stiffness (its version),
  /// the preconditioner and the multigrid hierarchy.
  class LinearSolver
  {
  public:
    /// Refers to all but the settings.
    LinearSolver(const LinearSolverSettings &settings,
                 const ContactSystem        &system,
                 SolidHierarchy             &hierarchies,
                 dealii::TimerOutput        &timer);

    /// The system's active set has changed, or the stiffness. Collective; before the first solve().
    void
    update();

    /// Solve from a zero start until the residual has fallen by the reduction, or below the
    /// absolute tolerance. What the preconditioner's start achieves does not count as reduction: it
    /// takes away the forces of stiff penalties, next to which all others look small. Returns the
    /// number of iterations; throws SolverFailure. Where the interface multigrid does not get there
    /// and the system is not too large for it, it is factorised from then on.
    unsigned int
    solve(LA::BlockVector       &x,
          const LA::BlockVector &rhs,
          double                 reduction,
          double                 absolute_tolerance,
          NegativeCurvature      curvature = NegativeCurvature::ignore);

    /// See SolidHierarchy::interface_includes_geometric_stiffness(). Returns whether they did.
    /// Those that there are stay as they are if that is not wanted any more.
    bool
    include_geometric_in_interface(bool wanted);

    /// Take a hierarchy of the stiffness as it is now, and zones that know of forces that turn.
    /// @return false: it was that, or the system is factorised
    bool
    request_rebuild();

    unsigned int
    multigrid_cycles() const
    {
      return cycles_before + (preconditioner ? preconditioner->multigrid_cycles() : 0);
    }

    /// True: the Krylov method did not converge, and the system is factorised instead.
    bool
    has_fallen_back() const
    {
      return has_failed_iterating;
    }

    /// CG has met a direction in the last solve along which the system is not positive.
    bool
    tangent_is_indefinite() const
    {
      return is_indefinite;
    }

    /// So in any solve so far that went on from there.
    bool
    met_negative_curvature() const
    {
      return was_ever_indefinite;
    }

  private:
    /// Zones do not know of forces that turn, and the system does.
    bool
    interface_lacks_geometric() const;
    /// After which there are other ways than more of them.
    unsigned int
    iteration_limit(NegativeCurvature curvature) const;
    /// See solve(), with the preconditioner at hand.
    unsigned int
    solve_once(LA::BlockVector       &x,
               const LA::BlockVector &rhs,
               double                 reduction,
               double                 absolute_tolerance,
               NegativeCurvature      curvature);
    /// Returns the number of iterations; throws SolverFailure.
    unsigned int
    iterate(Krylov                 krylov,
            double                 tolerance,
            LA::BlockVector       &x,
            const LA::BlockVector &rhs,
            NegativeCurvature      curvature);
    /// The same of CG.
    unsigned int
    conjugate_gradients(dealii::SolverControl &control,
                        LA::BlockVector       &x,
                        const LA::BlockVector &rhs,
                        NegativeCurvature      curvature);

    /// For the stiffness as it is now.
    void
    make_preconditioner();
    bool
    can_factorise() const;
    /// From here on, where that may help.
    /// @return false: it would not
    bool
    factorise(NegativeCurvature curvature);
    /// Take the iterations of a solution that has begun with a residual, and ended with another.
    void
    record_iterations(unsigned int iterations, double first, double last);

    LinearSolverSettings             settings;
    const ContactSystem             &system;
    SolidHierarchy                  &hierarchies;
    dealii::TimerOutput             &timer;
    std::shared_ptr<const Hierarchy> hierarchy;
    std::unique_ptr<Preconditioner>  preconditioner;
    unsigned int                     version              = 0; ///< of the stiffness, made for
    bool                             has_failed_iterating = false;
    bool                             is_indefinite        = false; ///< see tangent_is_indefinite()
    bool                             was_ever_indefinite  = false; ///< see met_negative_curvature()
    unsigned int                     cycles_before        = 0;     ///< of former preconditioners
  };
} // namespace Signorini
