// SPDX-License-Identifier: Apache-2.0
#include "driver/equilibrium.h"

#include "fields/friction_fields.h"
#include <signorini/contact/methods/method.h>

#include <algorithm>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Equilibrium<dim>::Equilibrium(const Decisions<dim>        &decisions,
                                Elasticity<dim>             &elasticity,
                                ContactInterfaces<dim>      &contact,
                                State                       &state,
                                TimerOutput                 &timer,
                                ConditionalOStream          &out,
                                std::function<StepVisitor()> watch)
    : configuration_solver(decisions.scene, elasticity, contact, state, timer, std::move(watch))
    , decisions(decisions)
    , scene(decisions.scene)
    , elasticity(elasticity)
    , contact(contact)
    , state(state)
    , timer(timer)
    , out(out)
    , my_uses_current_geometry(elasticity.is_finite_strain())
  {}



  // Replace the state; the volumetric stress of the bodies follows, and the surfaces are placed for
  // the next search.
  template <int dim>
  void
  Equilibrium<dim>::set_state(const State &other, const bool uses_current_geometry)
  {
    state = other;
    previous_solution.reset();
    restore_volumetric_stress();
    my_uses_current_geometry = uses_current_geometry;
    configuration_solver.set_configuration(uses_current_geometry ? state.displacement :
                                                                   LA::Vector());
  }



  template <int dim>
  void
  Equilibrium<dim>::restore_volumetric_stress()
  {
    VolumetricStress<dim> &volumetric = elasticity.volumetric_stress();
    volumetric.set_coefficients(state.volumetric_stress.size() > 0 ? state.volumetric_stress :
                                                                     volumetric.zero_vector());
  }



  // Everything computed on the old mesh is void: the solver, the extrapolation, the volumetric
  // stress (which starts from zero) and the gap operator. The displacement was transferred by the
  // caller.
  template <int dim>
  void
  Equilibrium<dim>::invalidate()
  {
    configuration_solver.invalidate();
    previous_solution.reset();
    state.volumetric_stress = LA::Vector();
    if (my_uses_current_geometry)
      configuration_solver.set_configuration(state.displacement);
    contact.invalidate();
  }



  template <int dim>
  Snapshot<dim>
  Equilibrium<dim>::snapshot(const State        &at,
                             const LA::Vector   &gap,
                             const ContactState &contact_state,
                             const LA::Vector   &active,
                             const unsigned int  step) const
  {
    return {elasticity,
            decisions.pairs,
            contact.surfaces(),
            contact.gap_operator(),
            at.displacement,
            gap,
            contact_state.pressure(),
            active,
            contact_state,
            at.friction_work,
            at.start.friction_bound,
            at.time,
            step};
  }



  template <int dim>
  Snapshot<dim>
  Equilibrium<dim>::snapshot(const unsigned int step) const
  {
    return snapshot(state, gap, configuration_solver.contact_state(), active, step);
  }



  // An iterate with NaN or infinite entries is of no use for output.
  template <int dim>
  std::optional<Snapshot<dim>>
  Equilibrium<dim>::failure(const unsigned int step) const
  {
    if (!my_failure || !std::isfinite(my_failure->state.displacement.l2_norm() +
                                      my_failure->contact.pressure().l2_norm()))
      return {};
    return snapshot(
      my_failure->state, my_failure->gap, my_failure->contact, my_failure->active, step);
  }



  // At finite strain the extrapolated displacement is tried first, then the displacement of the
  // last load step. Collective.
  template <int dim>
  bool
  Equilibrium<dim>::solve(const double t, const double tolerance)
  {
    my_failure.reset();
    if (const auto start = predicted(t))
      {
        if (solve_from(start, t, tolerance))
          return true;
        out << "  no solution from the extrapolated initial guess: " << my_report.reason
            << "; starting again from the last load step" << std::endl;
      }
    return solve_from({}, t, tolerance);
  }



  namespace
  {
    /// True if `now` equals the expected vector up to a tenth of its change since `before` (largest
    /// components).
    bool
    continues_motion(const LA::Vector &before, const LA::Vector &expected, const LA::Vector &now)
    {
      constexpr double small  = 0.1;
      LA::Vector       change = now, error = now;
      change -= before;
      error -= expected;
      return error.linfty_norm() <= small * change.linfty_norm() + 1e-12 * now.linfty_norm();
    }

    /// Linear extrapolation: last + times (last - previous_solution). @param times ratio of the
    /// lengths of the load steps
    LA::Vector
    extrapolated(const LA::Vector &previous_solution, const LA::Vector &last, const double times)
    {
      LA::Vector result = last;
      result.sadd(1 + times, -times, previous_solution);
      return result;
    }
  } // namespace



  template <int dim>
  std::optional<LA::Vector>
  Equilibrium<dim>::predicted(const double t)
  {
    if (!elasticity.is_finite_strain() || !previous_solution || t <= state.time)
      return {};
    // Extrapolate only if supports, obstacles and loads continue as in the last load step: the
    // prescribed displacements and the load vector at t are compared with their own extrapolations.
    const double times   = (t - state.time) / (state.time - previous_solution->time);
    const auto   load_at = [this](const double time) {
      elasticity.set_time(time);
      return elasticity.load();
    };
    const LA::Vector first = load_at(previous_solution->time), last = load_at(state.time),
                     now = load_at(t);
    LA::Vector start     = extrapolated(previous_solution->displacement, state.displacement, times),
               prescribed_increment = start;
    elasticity.distribute(prescribed_increment);
    if (!continues_motion(state.displacement, start, prescribed_increment) ||
        !continues_motion(last, extrapolated(first, last, times), now))
      return {};
    return start;
  }



  template <int dim>
  bool
  Equilibrium<dim>::is_path_dependent() const
  {
    return scene.contact.chosen().is_path_dependent() || !elasticity.material_history().empty() ||
           elasticity.locks_rigid_bodies();
  }



  template <int dim>
  bool
  Equilibrium<dim>::has_path_errors() const
  {
    const auto &method = scene.contact.chosen();
    return is_path_dependent() &&
           (method.has_friction || method.has_strength || method.has_late_ties ||
            !elasticity.material_history().empty() || elasticity.locks_rigid_bodies() ||
            elasticity.is_finite_strain() || uses_current_geometry());
  }



  // One load step from a given start. On success time, internal variables, gap and active set of
  // the solution are stored; at finite strain the solution is also checked for missed penetration,
  // for stability (indefinite tangent) and for a jump (displacement rate). On failure the last
  // iterate is kept for output, and state, active set and volumetric stress are restored. Returns
  // false then. Collective.
  template <int dim>
  bool
  Equilibrium<dim>::solve_from(const std::optional<LA::Vector> &start,
                               const double                     t,
                               const double                     tolerance)
  {
    // The start of the load step is stored only if the solution depends on the path.
    const State before = state;
    if (t > state.time && is_path_dependent())
      {
        if (state.friction_bound.empty() && starts_unloaded())
          state.friction_bound.assign(decisions.pairs.size(), 0.);
        state.start = {state.displacement,
                       state.contact,
                       state.material,
                       t - state.time,
                       state.friction_work,
                       state.friction_bound};
        configuration_solver.start_step();
      }
    try
      {
        start_fluids();
        if (solve_from_start(start, t, tolerance) && solve_while_state_changes(t, tolerance))
          {
            state.time     = t;
            state.material = elasticity.internal_variables(state.displacement);
            if (elasticity.is_finite_strain())
              {
                contact.check_missed_penetration(state.displacement,
                                                 configuration_solver.contact_state().pressure());
                my_report.tangent_is_indefinite =
                  configuration_solver.tangent_is_indefinite(state.displacement);
                my_report.speed_ratio = speed_ratio_since(before);
                previous_solution.reset();
                if (t > before.time && my_report.speed_ratio == 0)
                  previous_solution = PreviousSolution{before.displacement, before.time};
              }
            gap    = contact.gap_operator().gap(state.displacement);
            active = closed_points(configuration_solver.contact_state().status);
            if (scene.contact.chosen().has_friction)
              {
                add_critical_friction();
                const Snapshot<dim> now = snapshot(0);
                state.friction_bound    = bound_of_friction(now);
                state.friction_work =
                  work_of_friction(now, state.start.friction_work, state.friction_bound);
              }
            return true;
          }
      }
    catch (const SolverFailure &failure)
      {
        my_report        = NewtonReport();
        my_report.reason = failure.what();
        my_report.reason +=
          contact.overconstrained_nodes(closed_points(configuration_solver.contact_state().status));
      }
    // Negative curvature explains failures near buckling points; the hierarchy may be that of an
    // indefinite tangent and is released.
    my_report.tangent_is_indefinite =
      elasticity.is_finite_strain() &&
      (configuration_solver.met_negative_curvature() || is_indefinite_on_path_from(before));
    if (my_report.tangent_is_indefinite)
      configuration_solver.release();
    store_failure(t);
    return_to(before);
    return false;
  }



  template <int dim>
  void
  Equilibrium<dim>::return_to(const State &before)
  {
    state = before;
    configuration_solver.restore_active_set();
    restore_volumetric_stress();
  }



  // Store the last iterate for output; points of oscillating status are marked by 2.
  template <int dim>
  void
  Equilibrium<dim>::store_failure(const double t)
  {
    my_failure                   = Failure{state,
                         contact.gap_operator().gap(state.displacement),
                         configuration_solver.contact_state(),
                         closed_points(configuration_solver.contact_state().status)};
    my_failure->state.time       = t;
    const LA::Vector &chattering = my_report.chattering;
    for (const auto i : chattering.locally_owned_elements())
      if (chattering(i) > 0)
        my_failure->active(i) = 2;
    my_failure->active.compress(VectorOperation::insert);
  }



  // Solve at time t from an initial displacement. The steps are: prescribed values at t; with
  // current geometry, a check that no obstacle tunnels in the increment; contact search where
  // surfaces or gaps have changed; one solution on that configuration to a moderate tolerance; the
  // decision whether the contact geometry has to be updated; updates until convergence
  // (doc/theory, 5.2).
  template <int dim>
  bool
  Equilibrium<dim>::solve_from_start(const std::optional<LA::Vector> &start,
                                     const double                     t,
                                     const double                     tolerance)
  {
    elasticity.hold_rigid_bodies(state.displacement);
    elasticity.set_time(t);
    const LA::Vector last = state.displacement;
    state.displacement    = start.value_or(last);
    configuration_solver.set_initial_guess(state.displacement);
    elasticity.distribute(state.displacement);
    previous_steps.clear();
    if (my_uses_current_geometry && t == state.time)
      return update_geometry_until_converged(t,
                                             tolerance,
                                             !contact.is_outdated()); // only the mesh is another
    if (my_uses_current_geometry)
      {
        contact.check_tunnelling(last, state.displacement);
        LA::Vector configuration_displacement = state.displacement;
        // At finite strain the surfaces are searched at their last positions, with the obstacles
        // moved: displacements that satisfy the supports at t, but are not in equilibrium, would
        // fold cells.
        if (elasticity.is_finite_strain())
          {
            configuration_displacement = last;
            elasticity.set_rigid_motion(elasticity.rigid_motion(state.displacement),
                                        configuration_displacement);
          }
        configuration_solver.set_configuration(std::move(configuration_displacement));
        configuration_solver.find_contact(false);
      }
    else if (contact.is_outdated())
      configuration_solver.find_contact(false);
    StoppingCriteria stopping = first_stopping_criteria(tolerance, start.has_value());
    // With Contact geometry = automatic, Newton's method may stop early, once, if the estimate says
    // that an update is needed anyway.
    if (!my_uses_current_geometry && scene.contact.geometry == ContactGeometry::automatic)
      stopping.is_sufficient = [this, was_asked = false]() mutable {
        return !std::exchange(was_asked, true) && needs_geometry_update(false);
      };
    if (!solve_fixed_configuration(t, stopping))
      return false;
    return needs_geometry_update(true) ? update_geometry_until_converged(t, tolerance, false) :
                                         true;
  }



  // Solve on the present configuration; the report contains the steps of earlier configurations of
  // this load step, too.
  template <int dim>
  bool
  Equilibrium<dim>::solve_fixed_configuration(const double            t,
                                              const StoppingCriteria &stopping,
                                              const bool              is_near)
  {
    const bool is_solved = configuration_solver.solve(t, stopping, is_near);
    my_report            = configuration_solver.report();
    my_report.steps.insert(my_report.steps.begin(), previous_steps.begin(), previous_steps.end());
    return is_solved;
  }



  template class Equilibrium<2>;
  template class Equilibrium<3>;
} // namespace Signorini
