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
  /// Solves for equilibrium with contact evaluated on a fixed configuration of the surfaces,
  /// reference or displaced. Makes solids, hierarchies and the contact solver on demand and keeps
  /// them as long as they are valid. Searches again with larger tolerances if surfaces may have
  /// approached each other farther than contact was searched for.
  template <int dim>
  class FixedConfigurationSolver
  {
  public:
    /// Keeps references to all arguments but the last.
    /// @param state where solutions start, and what they become
    /// @param watch makes the function that is called in each Newton step
    FixedConfigurationSolver(const Scene<dim>            &scene,
                             Elasticity<dim>             &elasticity,
                             ContactInterfaces<dim>      &contact,
                             State                       &state,
                             dealii::TimerOutput         &timer,
                             std::function<StepVisitor()> watch);

    /// Set the configuration in which find_contact() will search next. @param u displacement;
    /// empty: reference configuration
    void
    set_configuration(LA::Vector u)
    {
      configuration_displacement = std::move(u);
    }

    /// See ContactInterfaces::build(). Pressures are restored from the state; active sets are not.
    void
    find_contact(bool is_near, bool keeps_integration_points = false);

    /// Throws SceneError if there are rigid-body modes that neither supports nor contact can
    /// constrain, and SolverFailure if that is so in the present configuration only.
    void
    check_motions()
    {
      make_unconstrained_modes();
    }

    /// Restore pressure and active set from the state.
    void
    restore_active_set();

    /// Start a load step: slip and internal variables of contact are measured from the start that
    /// the state holds.
    void
    start_step();

    /// After a solution: let overloaded bonds fail. Then the state is no longer a solution.
    /// Collective.
    /// @return whether any has failed
    bool
    break_bonds();

    /// Set the initial guess of the next solution. @param u displacement that satisfies the
    /// supports of that solution
    void
    set_initial_guess(LA::Vector u)
    {
      initial_guess          = std::move(u);
      had_negative_curvature = false;
    }

    /// Solve for the loads at time t. Throws SolverFailure. Collective.
    /// @param is_near passed on to find_contact() if contact has to be searched for again
    /// @return whether Newton's method converged, see report()
    bool
    solve(double t, const StoppingCriteria &stopping, bool is_near);

    /// The mesh has changed: discard all that depends on the old one.
    void
    invalidate();

    /// Free the memory of Newton's method and the multigrid method; the results are kept.
    void
    release();

    // Results of the last solution:

    /// The steps of Newton's method, or why it failed.
    const NewtonReport &
    report() const
    {
      return my_report;
    }

    /// Tractions, status and internal variables of the rows at the last iterate.
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

    /// See Newton::friction_over_critical(); 0 if there is no contact yet. Collective.
    double
    friction_over_critical()
    {
      return solver ? solver->newton.friction_over_critical(state.displacement, my_contact) : 0;
    }

    /// True if the tangent of any iterate since set_initial_guess() was found to be indefinite.
    bool
    met_negative_curvature() const
    {
      return had_negative_curvature || (solver && solver->linear_solver.met_negative_curvature());
    }

    /// The dual solution of a quantity at the last solution. Collective.
    DualSolution
    dual(const Functional &functional);

    // Costs on this mesh so far:

    /// The number of multigrid cycles.
    unsigned int
    multigrid_cycles() const
    {
      return former_cycles + (solver ? solver->linear_solver.multigrid_cycles() : 0);
    }

    /// Wall time of this rank's solves on this mesh [s].
    double
    seconds() const
    {
      return clock.wall_time();
    }

  private:
    /// Solve once on the present candidates.
    void
    solve_with_candidates(double t, const StoppingCriteria &stopping);
    /// Points whose pressure is rounding have the internal variables of open ones. Collective.
    void
    forget_slip_without_pressure();
    /// Points that rest on the bound of friction without slipping in the load step stick.
    /// Collective.
    void
    stick_without_slip();
    /// Make the solver and what it needs, as far as it does not exist.
    void
    make_solver();
    /// Make the solids.
    void
    assemble();
    /// The unconstrained rigid-body modes; may search contact again. See check_motions() for
    /// exceptions.
    UnconstrainedModes
    make_unconstrained_modes();
    /// Store tractions, status and internal variables of the last iterate in the state.
    void
    store_contact();
    /// Discard the solver; counters are kept.
    void
    reset_solver();

    const Scene<dim>                  &scene;
    Elasticity<dim>                   &elasticity;
    ContactInterfaces<dim>            &contact;
    State                             &state;
    dealii::TimerOutput               &timer;
    const std::function<StepVisitor()> watch;

    LA::Vector   configuration_displacement; ///< of the surfaces; empty: reference configuration
    LA::Vector   initial_guess;              ///< used up when the next solution begins
    ContactState my_contact;

    // On this mesh:
    std::unique_ptr<SolidResidual> bodies; ///< null until assembled
    std::optional<SolidHierarchy>  hierarchies;
    std::unique_ptr<ContactSolver> solver; ///< for the present result of the contact search

    NewtonReport  my_report;
    unsigned int  former_cycles          = 0;     ///< multigrid cycles of earlier solvers
    bool          had_negative_curvature = false; ///< an earlier solver has met negative curvature
    dealii::Timer clock;                          ///< runs during solves on this mesh
  };
} // namespace Signorini
