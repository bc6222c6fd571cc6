// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include "driver/fixed_configuration_solver.h"
#include "fields/snapshot.h"
#include "solid/fluid_spread.h"

#include <array>
#include <functional>
#include <optional>

namespace Signorini
{
  /// Solves for equilibrium at a given time: on a fixed contact configuration, and for large
  /// sliding by updating the contact geometry until it converges. Exists as long as the run; what
  /// depends on the mesh is made on demand, and discarded when the mesh changes.
  template <int dim>
  class Equilibrium
  {
  public:
    /// Keeps references to all arguments but the last.
    /// @param watch makes the function that is called in each Newton step; an exception that it
    /// throws ends the solution, with `state` as the last iterate left it
    Equilibrium(const Decisions<dim>        &decisions,
                Elasticity<dim>             &elasticity,
                ContactInterfaces<dim>      &contact,
                State                       &state,
                dealii::TimerOutput         &timer,
                dealii::ConditionalOStream  &out,
                std::function<StepVisitor()> watch);

    /// Solves with a fixed configuration of the contact surfaces.
    FixedConfigurationSolver<dim> configuration_solver;

    /// Search for contact in the present configuration of the surfaces.
    void
    find_contact()
    {
      configuration_solver.find_contact(my_uses_current_geometry);
    }

    /// Solve at time t, starting from `state`, which becomes the solution. Collective.
    /// @param t time, not earlier than that of the state
    /// @param tolerance of the residual, relative to the acting forces
    /// @return false if there is no solution; `state` is then unchanged, and report() has the
    /// reason
    bool
    solve(double t, double tolerance);

    /// Replace the state: by the undeformed one, or by that of a checkpoint.
    /// @param uses_current_geometry contact is searched for in the displaced configuration from now
    /// on
    void
    set_state(const State &other, bool uses_current_geometry);

    /// The mesh has changed, and the state was transferred to it: discard all that depends on the
    /// old one.
    void
    invalidate();

    // Results of the last solution:

    /// The steps of Newton's method on all configurations of the last load step, or why it failed.
    const NewtonReport &
    report() const
    {
      return my_report;
    }

    /// The last solution for output and evaluation; refers to `state` and the contact. @param step
    /// number of the load step
    Snapshot<dim>
    snapshot(unsigned int step) const;

    /// The last iterate where solve() failed, for output; points whose status oscillates have 2 in
    /// `active`. Empty if there is nothing to be shown.
    std::optional<Snapshot<dim>>
    failure(unsigned int step) const;

    /// True if contact is evaluated in the current configuration, false in the reference
    /// configuration.
    bool
    uses_current_geometry() const
    {
      return my_uses_current_geometry;
    }

    /// The largest deviation of prescribed displacements and of loads from straight lines between
    /// two times, relative to their largest values up to the end of the history. Collective.
    double
    turn_of_loads(double from, double to);

    /// The largest deviation of prescribed displacements and of loads from the straight way from
    /// their values at one time to those at another, on which they may advance at any speed, but
    /// not return; relative to their largest values up to the end of the history. Collective.
    double
    deviation_of_loads(double from, double to);

    /// The largest angle by which an obstacle turns between now and a time [radian], if the contact
    /// geometry is the current one; else zero. Collective.
    double
    turn_of_obstacles(double t);

    /// The largest angle by which the two sides of a pair with friction, surfaces of bodies or
    /// obstacles, have turned relative to each other since a displacement [radian, at most pi], if
    /// the contact geometry is the current one; else zero. Collective.
    double
    relative_turn_since(const LA::Vector &before);

    /// Return to a state of this mesh, to solve the load steps after it again. Collective.
    void
    return_to(const State &before);

    /// True if the solution depends on earlier load steps, by contact or by the materials.
    bool
    is_path_dependent() const;
    /// True if the solution changes with the length of the load steps: not that of ties that hold
    /// at small strain, although they remember where their points are.
    bool
    has_path_errors() const;

    /// The relative change of the contact pressure that the current configuration would make, if it
    /// was estimated.
    std::optional<double>
    neglected() const
    {
      return my_neglected;
    }

  private:
    /// Prescribed displacements [length] and loads [force], by degree of freedom.
    using Loading = std::array<LA::Vector, 2>;
    /// Those at a time. Sets largest_loads; leaves the time of the bodies there. Collective.
    Loading
    loading_at(double t);
    /// True if nothing acts on the bodies at the time of the state: no loads, no prescribed
    /// displacements, and no overlaps with each other or with obstacles. Collective.
    bool
    starts_unloaded();
    /// The largest entry relative to largest_loads.
    double
    relative_size(const Loading &loading) const;
    /// True if the contact geometry is, or may become, the current one.
    bool
    may_follow_turns() const;
    /// See solve().
    /// @param start displacement at which the bodies are linearised first, from predicted(); else
    /// that of the state. The contact search starts with the surfaces of the state in any case,
    /// since predicted surfaces may have penetrated each other undetected
    bool
    solve_from(const std::optional<LA::Vector> &start, double t, double tolerance);
    /// At finite strain: the displacement extrapolated from the last load step, if there was one on
    /// this mesh and supports and loads continue as in it.
    std::optional<LA::Vector>
    predicted(double t);
    /// One attempt of solve_from(), without restoring the state if it fails.
    bool
    solve_from_start(const std::optional<LA::Vector> &start, double t, double tolerance);
    /// After a solution at time t: solve again, from the present state, while bonds fail or fluids
    /// spread.
    bool
    solve_while_state_changes(double t, double tolerance);
    /// Before a load step: let fluids be where surfaces are open. Collective.
    void
    start_fluids();
    /// After a solution: let fluids spread. Collective.
    /// @return whether any has
    bool
    spread_fluids(FluidSpread spread);
    /// Store the last iterate of a failed load step, for failure().
    void
    store_failure(double t);
    /// The ratio of the displacement rate to that of the last load step, see
    /// NewtonReport::speed_ratio.
    double
    speed_ratio_since(const State &before);
    /// Add NewtonReport::friction_over_critical, in the first and the last load step with slip, and
    /// while it is large. Collective.
    void
    add_critical_friction();
    /// True if the tangent is indefinite somewhere on the straight line from the displacement of
    /// `before` to the present one.
    bool
    is_indefinite_on_path_from(const State &before);
    /// Restore the volumetric stress of the state.
    void
    restore_volumetric_stress();
    /// Solve on the fixed configuration, and put the steps of earlier configurations of this load
    /// step before its own in the report.
    bool
    solve_fixed_configuration(double t, const StoppingCriteria &stopping, bool is_near = false);
    /// The stopping criteria of the first solution of a load step, before the contact geometry is
    /// updated.
    StoppingCriteria
    first_stopping_criteria(double tolerance, bool is_predicted) const;
    /// The stopping criteria after an update of the contact geometry: at finite strain a single
    /// Newton step.
    /// @param before largest residual at the last update; 0: there was none
    StoppingCriteria
    next_stopping_criteria(double tolerance, double before) const;
    /// True if the surfaces move so far that contact has to be evaluated in the current
    /// configuration; reports the estimated change.
    /// @param is_solution the displacement is a solution; else it is close to one, and nothing is
    /// reported unless the answer is true
    bool
    needs_geometry_update(bool is_solution);
    /// Update the contact geometry and solve, alternately, until the configuration no longer
    /// changes: a Newton method for the dependence of gaps and normals on the displacement, which
    /// converges quadratically near the solution (doc/theory, 5).
    /// @param is_placed the surfaces are in the current configuration already
    bool
    update_geometry_until_converged(double t, double tolerance, bool is_placed);
    Snapshot<dim>
    snapshot(const State        &state,
             const LA::Vector   &gap,
             const ContactState &contact_state,
             const LA::Vector   &active,
             unsigned int        step) const;

    const Decisions<dim>       &decisions;
    const Scene<dim>           &scene;
    Elasticity<dim>            &elasticity;
    ContactInterfaces<dim>     &contact;
    State                      &state;
    dealii::TimerOutput        &timer;
    dealii::ConditionalOStream &out;

    LA::Vector            gap, active; ///< at the contact points: gap [length]; 1 if active, else 0
    bool                  my_uses_current_geometry = false;
    std::optional<double> my_neglected;
    NewtonReport          my_report;
    /// The Newton steps of this load step in earlier contact configurations.
    std::vector<NewtonStep> previous_steps;

    double last_friction_over_critical = 0; ///< that was determined
    double last_speed                  = 0; ///< displacement per time in the last load step
    double last_prescribed_speed = 0; ///< the part of it that supports and obstacles prescribe

    /// The solution before the last load step, if it was on this mesh.
    struct PreviousSolution
    {
      LA::Vector displacement;
      double     time;
    };
    std::optional<PreviousSolution> previous_solution;

    /// The largest prescribed displacement and load of the history, for turn_of_loads().
    std::array<double, 2> largest_loads{{0, 0}};

    /// The last iterate of a failed load step.
    struct Failure
    {
      State        state;
      LA::Vector   gap;
      ContactState contact;
      LA::Vector   active;
    };
    std::optional<Failure> my_failure;
  };
} // namespace Signorini
