// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"
#include "solver/active_set_strategy.h"
#include "solver/convergence_criteria.h"
#include "solver/dual_solution.h"
#include "solver/linear_solver.h"
#include <signorini/solver/newton_settings.h>

#include <functional>

namespace Signorini
{
  /// How far Newton's method goes.
  struct StoppingCriteria
  {
    double tolerance = 1e-10; ///< of the residual, relative to the forces at work
    /// After so many steps the result counts, however far from balance, once the active set stays:
    /// where surfaces will be placed anew in any case. Then linear solves find no more digits than
    /// a step of Newton's method.
    unsigned int sufficient_steps = dealii::numbers::invalid_unsigned_int;

    /// Asked where the active set stays, once not even a thousandth is out of balance: is that
    /// enough?
    std::function<bool()> is_sufficient;

    bool
    is_partial() const
    {
      return sufficient_steps != dealii::numbers::invalid_unsigned_int;
    }
  };

  /// Semismooth Newton method for the balance of bodies and contact, F(u) = f + B^T W p, with the
  /// contact law between p and the gap. Where all but the law is linear, it is the primal-dual
  /// active set strategy (Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2003) 865).
  ///
  /// Full steps, which find the active set in a few, until one comes up again. If it still does
  /// with finer linear solves, then from there on
  /// methods with multipliers change one point at a time, the worst; the others minimise a convex
  /// energy (but for Nitsche's method with theta = 0 or -1, and mixed bodies), along which each
  /// step is searched exactly: it costs vectors of the surface only. If the method augments, one
  /// solution follows the other. Steps of bodies that deform by any amount go no farther than their
  /// energy falls, see energy_descending_step().
  class Newton
  {
  public:
    /// Refers to all but the settings.
    /// @param system that of the bodies and the law
    /// @param linear_solver of the system
    Newton(const NewtonSettings &settings,
           SolidResidual        &bodies,
           ContactLaw           &law,
           ContactSystem        &system,
           LinearSolver         &linear_solver);

    /// Is the linearisation at a solution not positive definite? Solves it for forces without any
    /// symmetry, which see what those of a solution do not: a straight column that would buckle.
    /// Seen by CG; of mixed bodies by inverse iteration, and there only as long as nothing else is
    /// closer to zero. Collective.
    bool
    tangent_is_indefinite(const LA::Vector &u, const ContactState &state);

    void
    set_stopping_criteria(const StoppingCriteria &wanted)
    {
      stopping = wanted;
      convergence.set_tolerance(stopping.tolerance);
    }

    /// @param u in: start, with the prescribed displacements of this step; out: solution
    /// @param state of contact, in: start, with the internal variables of the last load step, which
    /// stay; out: tractions and statuses of the solution
    NewtonReport
    solve(LA::Vector &u, ContactState &state, const StepVisitor &visit);

    /// The internal variables of the contact law at the end of a load step that has come to u.
    InternalFields
    internal(const LA::Vector &u, const ContactState &state) const;

    /// The dual solution of a quantity at the solution that solve() has returned. The linearisation
    /// is that of the contact law as it is there; of Uzawa's method that of its springs.
    /// @param state of contact there
    /// @param of_displacement derivative by the free degrees of freedom
    /// @param of_pressure by the pressures at the contact points
    /// @param reduction of the residual
    DualSolution
    dual(const LA::Vector   &u,
         const ContactState &state,
         const LA::Vector   &of_displacement,
         const LA::Vector   &of_pressure,
         double              reduction);

  private:
    /// One step: where the bodies are out of balance, and the right-hand side of the next system.
    struct Stage
    {
      PointVectors    gap, stress;
      LA::BlockVector rhs;
      NewtonStep      step;
      bool            penalty_scale_changed = false;
      double          damping               = 1; ///< of the next step
    };

    /// The law at u, and the residuals; updates statuses and tractions.
    void
    evaluate(const LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage);
    /// Is that the solution, or why will there be none? Or it is that of an augmentation, and the
    /// next one starts.
    void
    assess(const ContactState &state, NewtonReport &report, Stage &stage);
    /// Solve the linear system, and move on.
    void
    advance(LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage);
    void
    solve_linear(const LA::BlockVector &rhs, double reduction, double tolerance, NewtonStep &step);
    /// Of mixed bodies, whose saddle points are not solved by CG: do forces, or those that inverse
    /// iteration makes of them, do negative work on the way that they push? That tends to the
    /// motion whose stiffness is closest to zero, which is the one that has become negative last.
    bool
    finds_negative_curvature(LA::BlockVector forces);
    /// Returns the number of iterations.
    unsigned int
    iterate(const LA::BlockVector &rhs, double reduction, double tolerance, double residual);
    /// The linear system is that of the bodies at u, and of the law at these inputs.
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

    LA::BlockVector x;               ///< the change of (u, q)
    bool            is_same = false; ///< the linear system has the present statuses
    unsigned int    version = 0;     ///< and the stiffness of that version
  };
} // namespace Signorini
