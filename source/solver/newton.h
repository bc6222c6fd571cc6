// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"
#include "solver/active_set.h"
#include "solver/convergence_criteria.h"
#include "solver/dual_solution.h"
#include "solver/linear_solver.h"
#include <signorini/solver/newton_settings.h>

#include <functional>

namespace Signorini
{
  /// When Newton's method stops.
  struct StoppingCriteria
  {
    double tolerance = 1e-10; ///< of the residual, relative to the acting forces
    /// Accept the result after this number of steps, whatever its residual, once the active set no
    /// longer changes; for solutions after which the contact geometry is updated anyway. The linear
    /// solver then reduces the residual only as far as a Newton step would.
    unsigned int sufficient_steps = dealii::numbers::invalid_unsigned_int;

    /// Called when the active set does not change and the relative residual is below 1e-3; true:
    /// accept the result.
    std::function<bool()> is_sufficient = {};

    /// True if a result may be accepted before the residual meets the tolerance.
    bool
    is_partial() const
    {
      return sufficient_steps != dealii::numbers::invalid_unsigned_int;
    }
  };

  /// Semismooth Newton method for the equilibrium of solids and contact, F(u) = f + B^T W p, with
  /// the contact law between p and the gap (doc/theory, 4). Where all but the law is linear, it is
  /// the primal-dual active set strategy (Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2003)
  /// 865).
  ///
  /// Iteration: evaluate the law and the residuals, update the active set, linearise, solve,
  /// update. Steps are full, and mostly find the active set in a few, until a set comes up again.
  /// If it still does so with more accurate linear solves, then from there on methods with
  /// multipliers change one point at a time, the one that violates the law most; the others
  /// minimise a convex energy by an exact line search, which costs vectors on the surface only
  /// (except for Nitsche's method with theta = 0 or -1, and bodies in displacement-pressure form,
  /// which have no such energy). If the law augments, each solution starts the next augmentation.
  /// Steps of bodies at finite strain are shortened until their energy decreases, see
  /// energy_descending_step(). Ends with convergence, or after NewtonSettings::maximum_steps.
  class Newton
  {
  public:
    /// Keeps references to all arguments but the settings.
    /// @param system that of the bodies and the law
    /// @param linear_solver of the system
    Newton(const NewtonSettings &settings,
           SolidResidual        &bodies,
           ContactLaw           &law,
           ContactSystem        &system,
           LinearSolver         &linear_solver);

    /// True if the linearisation at a solution is not positive definite. Solves it for forces
    /// without any symmetry, which contain modes that the forces of the solution do not excite,
    /// such as the buckling of a straight column. Detected by CG; with bodies in
    /// displacement-pressure form by inverse iteration, and there only if no other eigenvalue is
    /// closer to zero. Collective.
    bool
    tangent_is_indefinite(const LA::Vector &u, const ContactState &state);

    /// The friction at a solution relative to a critical one, at which other solutions appear
    /// (doc/theory, (4.24)): beyond 1 there are others. 0 where nothing slips with friction.
    /// Collective.
    double
    friction_over_critical(const LA::Vector &u, const ContactState &state);

    /// Change the criteria for the next solve().
    void
    set_stopping_criteria(const StoppingCriteria &wanted)
    {
      stopping = wanted;
      convergence.set_tolerance(stopping.tolerance);
    }

    /// Solve. Collective.
    /// @param u in: start, with the prescribed displacements of this step; out: solution
    /// @param state of contact; in: start, with the internal variables of the last load step, which
    /// are not changed; out: tractions and statuses of the solution
    /// @param visit called after each step
    NewtonReport
    solve(LA::Vector &u, ContactState &state, const StepVisitor &visit);

    /// The internal variables of the contact law at the end of a load step with solution u.
    InternalFields
    internal(const LA::Vector &u, const ContactState &state) const;

    /// The dual solution of a quantity at the solution that solve() has returned, with the
    /// linearisation of the contact law there; for Uzawa's method that of its penalty. Collective.
    /// @param state of contact at the solution
    /// @param of_displacement derivative by the free degrees of freedom
    /// @param of_volumetric_stress derivative by the coefficients of the volumetric stress; empty:
    /// zero
    /// @param of_traction derivative by each component of the tractions at the contact points
    /// @param reduction of the residual of the linear system
    DualSolution
    dual(const LA::Vector   &u,
         const ContactState &state,
         const LA::Vector   &of_displacement,
         const LA::Vector   &of_volumetric_stress,
         const PointVectors &of_traction,
         double              reduction);

  private:
    /// The data of one Newton step: gaps and stresses at the points, the right-hand side of the
    /// linear system, and what is reported.
    struct Stage
    {
      PointVectors    gap, stress;
      LA::BlockVector rhs;
      NewtonStep      step;
      bool            penalty_scale_changed = false;
      double          damping               = 1; ///< of the next step
    };

    /// Evaluate the law and the residuals at u, and update statuses and tractions.
    void
    evaluate(const LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage);
    /// Decide whether the iterate is the solution, or why there will be none. If it is the solution
    /// of an augmentation, start the next one.
    void
    assess(const ContactState &state, NewtonReport &report, Stage &stage);
    /// Solve the linear system, determine the step length, and update u and the tractions.
    void
    advance(LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage);
    /// Solve the linear system for the increment, and record the iterations in the step. Increments
    /// of constrained degrees of freedom are zero; those of multipliers become tractions.
    /// Collective.
    void
    solve_linear(const LA::BlockVector &rhs, double reduction, double tolerance, NewtonStep &step);
    /// True if the tangent has negative curvature along a direction found by inverse iteration: the
    /// Rayleigh quotient of the solution for the given forces, or for those of the next iterations,
    /// is negative. The iteration tends to the mode whose stiffness is closest to zero, which is
    /// the one that has become negative last. For bodies in displacement-pressure form, whose
    /// saddle points CG does not solve.
    bool
    finds_negative_curvature(LA::BlockVector forces);
    /// Returns the number of iterations.
    unsigned int
    iterate(const LA::BlockVector &rhs, double reduction, double tolerance, double residual);
    /// Linearise solids at u and the law at these inputs.
    void
    linearise(const LA::Vector &u, const LawInputs &in);

    NewtonSettings      settings;
    SolidResidual      &bodies;
    ContactLaw         &law;
    const GapOperator  &contact;
    ContactSystem      &system;
    LinearSolver       &linear_solver;
    ConvergenceCriteria convergence;
    ActiveSetStrategy   strategy;
    StoppingCriteria    stopping;

    LA::BlockVector x;               ///< the increment of (u, q), and of m
    bool            is_same = false; ///< the linear system is that of the present statuses
    unsigned int    version = 0;     ///< version of the stiffness in the linear system
  };
} // namespace Signorini
