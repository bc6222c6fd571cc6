// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/contact_interfaces.h"
#include "driver/state.h"
#include "solver/contact_solver.h"

#include <functional>
#include <memory>
#include <optional>

namespace Signorini
{
  /// The bodies in balance with contact as it is found at one place of the surfaces: at rest, or
  /// displaced. Makes bodies, hierarchies and the solver when they are needed, keeps them as long
  /// as they hold, and searches farther where surfaces may have come closer than contact was
  /// looked for.
  template <int dim>
  class FixedConfigurationSolver
  {
  public:
    /// Refers to all of them.
    /// @param state where solutions start, and what they become
    /// @param watch makes what is called in each step of Newton's method
    FixedConfigurationSolver(const Scene<dim>            &scene,
                             Elasticity<dim>             &elasticity,
                             ContactInterfaces<dim>      &contact,
                             State                       &state,
                             dealii::TimerOutput         &timer,
                             std::function<StepVisitor()> watch);

    /// Where surfaces will be when contact is found next. @param u empty: at rest
    void
    set_configuration(LA::Vector u)
    {
      configuration_displacement = std::move(u);
    }

    /// See ContactInterfaces::build(). Pressures are those of the state, of active sets nothing is
    /// kept.
    void
    find_contact(bool is_near, bool keeps_integration_points = false);

    /// Throws SceneError for motions that nothing can stop, SolverFailure if that is only so where
    /// surfaces are now.
    void
    check_motions()
    {
      make_unconstrained_modes();
    }

    /// Pressure and active set of the state.
    void
    restore_active_set();

    /// A load step starts: slip and internal variables of contact count from the start that the
    /// state has.
    void
    start_step();

    /// Bodies go on from there, where the next solution begins. @param u satisfies the supports of
    /// that solution
    void
    set_initial_guess(LA::Vector u)
    {
      initial_guess          = std::move(u);
      had_negative_curvature = false;
    }

    /// Solve for the loads at time t. Throws SolverFailure.
    /// @param is_near where contact has to be found again
    /// @return what it came to: whether converged() in report()
    bool
    solve(double t, const StoppingCriteria &stopping, bool is_near);

    /// The mesh is another one.
    void
    invalidate();

    /// Newton's method, multigrid and all that they hold; the results stay.
    void
    release();

    // Of the last solution:

    const NewtonReport &
    report() const
    {
      return my_report;
    }

    const ContactState &
    contact_state() const
    {
      return my_contact;
    }

    /// See Newton::tangent_is_indefinite(); false if there is no contact yet. Collective.
    bool
    tangent_is_indefinite(const LA::Vector &u)
    {
      return solver && solver->newton.tangent_is_indefinite(u, my_contact);
    }

    /// So was one on the way, since set_initial_guess().
    bool
    met_negative_curvature() const
    {
      return had_negative_curvature || (solver && solver->linear_solver.met_negative_curvature());
    }

    /// Its reaction to changes, seen by a quantity. Collective.
    DualSolution
    dual(const Functional &functional);

    // On this mesh so far:

    unsigned int
    multigrid_cycles() const
    {
      return former_cycles + (solver ? solver->linear_solver.multigrid_cycles() : 0);
    }

    /// Of this rank.
    double
    seconds() const
    {
      return clock.wall_time();
    }

  private:
    void
    solve_with_candidates(double t, const StoppingCriteria &stopping);
    void
    make_solver();
    void
    assemble();
    UnconstrainedModes
    make_unconstrained_modes();
    void
    reset_solver();

    const Scene<dim>                  &scene;
    Elasticity<dim>                   &elasticity;
    ContactInterfaces<dim>            &contact;
    State                             &state;
    dealii::TimerOutput               &timer;
    const std::function<StepVisitor()> watch;

    LA::Vector   configuration_displacement; ///< displacement of surfaces; empty: at rest
    LA::Vector   initial_guess;              ///< the last solution, until the next has begun
    ContactState my_contact;

    // On this mesh:
    std::unique_ptr<SolidResidual> bodies; ///< once they are assembled
    std::optional<SolidHierarchy>  hierarchies;
    std::unique_ptr<ContactSolver> solver; ///< for contact as it was found last

    NewtonReport  my_report;
    unsigned int  former_cycles          = 0;     ///< of multigrid, before `solver`
    bool          had_negative_curvature = false; ///< likewise
    dealii::Timer clock;                          ///< of the solves on this mesh
  };
} // namespace Signorini
