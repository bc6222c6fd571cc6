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
  /// The treatment of directions of negative curvature in CG.
  enum class NegativeCurvature
  {
    /// Continue.
    ignore,
    /// Throw IndefiniteSystem.
    report,
    /// Throw IndefiniteSystem, also if so many iterations were needed that an indefinite tangent is
    /// likely.
    reject,
    /// As `reject`, but return the iterate before it (Steihaug, SIAM J. Numer. Anal. 20 (1983)
    /// 626).
    truncate
  };

  /// Solves the contact systems of one mesh. Rebuilds only what has changed: after a change of the
  /// active set, what the preconditioner stores of the surface; after a change of the stiffness (of
  /// its version), the preconditioner and the multigrid hierarchy.
  class LinearSolver
  {
  public:
    /// Keeps references to all arguments but the settings.
    LinearSolver(const LinearSolverSettings &settings,
                 const ContactSystem        &system,
                 SolidHierarchy             &hierarchies,
                 dealii::TimerOutput        &timer);

    /// To be called when the active set or the stiffness of the system has changed, and before the
    /// first solve(). Collective.
    void
    update();

    /// Solve with initial value zero until the residual is reduced by a factor, or below the
    /// absolute tolerance. The reduction is measured after the preconditioner's start(), which
    /// removes the forces of stiff penalties, beside which all others would look small. If
    /// interface multigrid does not converge and the system is small enough, it is factorised from
    /// then on. Returns the number of iterations; throws SolverFailure. Collective.
    unsigned int
    solve(LA::BlockVector       &x,
          const LA::BlockVector &rhs,
          double                 reduction,
          double                 absolute_tolerance,
          NegativeCurvature      curvature = NegativeCurvature::ignore);

    /// Set SolidHierarchy::interface_includes_geometric_stiffness(). Returns its former value.
    /// Existing preconditioners that include it are kept.
    bool
    include_geometric_in_interface(bool wanted);

    /// Rebuild hierarchy and preconditioner for the present stiffness, and include the geometric
    /// stiffness in the interface solve.
    /// @return false if they are up to date already, or the system is factorised
    bool
    request_rebuild();

    /// Number of multigrid cycles of all preconditioners so far.
    unsigned int
    multigrid_cycles() const
    {
      return cycles_before + (preconditioner ? preconditioner->multigrid_cycles() : 0);
    }

    /// True if the Krylov method did not converge, and the system is factorised instead.
    bool
    has_fallen_back() const
    {
      return has_failed_iterating;
    }

    /// True if CG met a direction of negative curvature in the last solve.
    bool
    tangent_is_indefinite() const
    {
      return is_indefinite;
    }

    /// True if CG met a direction of negative curvature in any solve that ignored it.
    bool
    met_negative_curvature() const
    {
      return was_ever_indefinite;
    }

  private:
    /// True if the system has a geometric stiffness that the interface solve does not include.
    bool
    interface_lacks_geometric() const;
    /// The maximal number of iterations before something else is tried.
    unsigned int
    iteration_limit(NegativeCurvature curvature) const;
    /// See solve(), with the present preconditioner.
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
    /// Conjugate gradients with the treatment of negative curvature. Returns the number of
    /// iterations; throws SolverFailure.
    unsigned int
    conjugate_gradients(dealii::SolverControl &control,
                        LA::BlockVector       &x,
                        const LA::BlockVector &rhs,
                        NegativeCurvature      curvature);

    /// Make the preconditioner for the present stiffness.
    void
    make_preconditioner();
    /// True if the system is small enough for a factorisation as a fallback.
    bool
    can_factorise() const;
    /// Factorise the system from now on.
    /// @return false if that would not help
    bool
    factorise(NegativeCurvature curvature);
    /// Record the iterations per digit of a solution for the hierarchy.
    /// @param first initial residual @param last final residual
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
