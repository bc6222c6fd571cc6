#pragma once

#include <signorini/contact/law/normal_contact.h>
#include <signorini/solve/newton.h>

namespace Signorini
{
  /// All that Newton's method needs for contact as it was found: the law, the linear system of
  /// bodies and law, its solver. Goes when contact is looked for again.
  class ContactSolver
  {
  public:
    /// Refers to bodies, contact, hierarchies and timer.
    ContactSolver(const NewtonSettings       &newton_settings,
                  const LinearSolverSettings &linear_settings,
                  const ContactMethod        &method,
                  Bodies                     &bodies,
                  const GapOperator          &contact,
                  FreeMotions                 free_motions,
                  BodiesHierarchy            &hierarchies,
                  dealii::TimerOutput        &timer)
      : law(method, contact)
      , system(bodies.stiffness(),
               law,
               std::move(free_motions),
               bodies.bulk() ? &bodies.bulk()->coupling() : nullptr,
               bodies.is_symmetric())
      , linear_solver(linear_settings, system, hierarchies, timer)
      , newton(newton_settings, bodies, law, system, linear_solver)
    {}

    /// See Newton::solve().
    NewtonReport
    solve(LA::Vector &u, LA::Vector &p, LA::Vector &active, const StepVisitor &visit)
    {
      return newton.solve(u, p, active, visit);
    }

    /// Of Newton's method, from then on.
    void
    set_goal(const NewtonGoal &goal)
    {
      newton.set_goal(goal);
    }

    /// See Newton::dual().
    DualSolution
    dual(const LA::Vector &u,
         const LA::Vector &p,
         const LA::Vector &active,
         const LA::Vector &of_displacement,
         const LA::Vector &of_pressure,
         const double      reduction)
    {
      return newton.dual(u, p, active, of_displacement, of_pressure, reduction);
    }

    /// See Newton::curves_down().
    bool
    curves_down(const LA::Vector &u)
    {
      return newton.curves_down(u);
    }

    /// See LinearSolver::has_curved_down().
    bool
    has_curved_down() const
    {
      return linear_solver.has_curved_down();
    }

    unsigned int
    multigrid_cycles() const
    {
      return linear_solver.multigrid_cycles();
    }

  private:
    NormalContact law;
    ContactSystem system;
    LinearSolver  linear_solver;
    Newton        newton;
  };
} // namespace Signorini
