#pragma once

#include <signorini/solve/balance.h>
#include <signorini/solve/linear_solver.h>
#include <signorini/solve/newton_settings.h>
#include <signorini/solve/set_strategy.h>

namespace Signorini
{
  /// Semismooth Newton method for K u = f + B^T W p with the contact law between p and the gap:
  /// since all else is linear, it is the primal-dual active set strategy (Hintermueller, Ito,
  /// Kunisch, SIAM J. Optim. 13 (2003) 865). Lives as long as the mesh does.
  ///
  /// Full steps, which find the active set in a few, until one comes up again. If it still does
  /// with finer linear solves, then from there on
  /// methods with multipliers change one point at a time, the worst; the others minimise a convex
  /// energy (but for Nitsche's method with theta = 0 or -1), along which each step is searched
  /// exactly: it costs vectors of the surface only. If the method augments, one solution follows
  /// the other.
  class Newton
  {
  public:
    /// Refers to all but the settings and numbers.
    /// @param hierarchy make_hierarchy() of the stiffness
    /// @param bodies Elasticity::bodies_of_dofs()
    /// @param geometric see ContactSystem
    Newton(const NewtonSettings                    &settings,
           const LinearSolverSettings              &linear_settings,
           const ContactMethod                     &method,
           const LA::SparseMatrix                  &stiffness,
           const dealii::AffineConstraints<double> &constraints,
           const GapOperator                       &contact,
           std::shared_ptr<const Hierarchy>         hierarchy,
           const std::vector<unsigned int>         &bodies,
           unsigned int                             dim,
           dealii::TimerOutput                     &timer,
           FreeMotions                              free_motions = FreeMotions(),
           const LA::SparseMatrix                  *geometric    = nullptr);

    /// @param f load vector with prescribed displacements eliminated
    /// @param u in: start, with the prescribed displacements of this step; out: solution
    /// @param p pressure at the contact points, in: start, out: solution
    /// @param active the points that carry it, 1 or 0, likewise
    NewtonReport
    solve(const LA::Vector  &f,
          LA::Vector        &u,
          LA::Vector        &p,
          LA::Vector        &active,
          const StepVisitor &visit);

    unsigned int
    multigrid_cycles() const
    {
      return linear_solver.multigrid_cycles();
    }

  private:
    /// One step: where the bodies are out of balance, and the right-hand side of the next system.
    struct Stage
    {
      LA::Vector      gap, stress;
      LA::BlockVector rhs;
      NewtonStep      step;
      bool            softness_changed = false;
      double          damping          = 1; ///< of the next step
    };

    /// The law at u, and the residuals; updates the active set and the pressure.
    void
    evaluate(const LA::Vector &f,
             const LA::Vector &u,
             LA::Vector       &p,
             LA::Vector       &active,
             NewtonReport     &report,
             Stage            &stage);
    /// Is that the solution, or why will there be none? Or it is that of an augmentation, and the
    /// next one starts.
    void
    judge(const LA::Vector &p, NewtonReport &report, Stage &stage);
    /// Solve the linear system, and move on.
    void
    advance(LA::Vector &u, LA::Vector &p, NewtonReport &report, Stage &stage);
    void
    solve_linear(const LA::BlockVector &rhs, double reduction, double tolerance, NewtonStep &step);

    const NewtonSettings                     settings;
    const dealii::AffineConstraints<double> &constraints;
    const GapOperator                       &contact;
    ContactLaw                               law;
    ContactSystem                            system;
    LinearSolver                             linear_solver;
    Balance                                  balance;
    SetStrategy                              strategy;

    LA::BlockVector x;                  ///< the change of (u, q)
    bool            factorised = false; ///< the system is that of the active set
  };
} // namespace Signorini
