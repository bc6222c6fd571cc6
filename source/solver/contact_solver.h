#pragma once

#include "solver/newton.h"
#include <signorini/contact/methods/method.h>

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
      : law(method.make_law(contact))
      , system(bodies.stiffness(),
               *law,
               std::move(free_motions),
               bodies.bulk() ? &bodies.bulk()->coupling() : nullptr,
               bodies.is_symmetric())
      , linear_solver(linear_settings, system, hierarchies, timer)
      , newton(newton_settings, bodies, *law, system, linear_solver)
    {}

    /// See Newton::solve().
    NewtonReport
    solve(LA::Vector &u, ContactState &contact, const StepVisitor &visit)
    {
      return newton.solve(u, contact, visit);
    }

    /// See Newton::internal().
    InternalFields
    internal(const LA::Vector &u, const ContactState &contact) const
    {
      return newton.internal(u, contact);
    }

    /// Of Newton's method, from then on.
    void
    set_goal(const NewtonGoal &goal)
    {
      newton.set_goal(goal);
    }

    /// See Newton::dual().
    DualSolution
    dual(const LA::Vector   &u,
         const ContactState &contact,
         const LA::Vector   &of_displacement,
         const LA::Vector   &of_pressure,
         const double        reduction)
    {
      return newton.dual(u, contact, of_displacement, of_pressure, reduction);
    }

    /// See Newton::curves_down().
    bool
    curves_down(const LA::Vector &u, const ContactState &contact)
    {
      return newton.curves_down(u, contact);
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
    std::unique_ptr<ContactLaw> law;
    ContactSystem               system;
    LinearSolver                linear_solver;
    Newton                      newton;
  };
} // namespace Signorini
