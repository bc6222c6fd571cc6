#include "driver/equilibrium.h"

#include <signorini/base/text.h>
#include <signorini/contact/methods/method.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Equilibrium<dim>::Equilibrium(const Decisions<dim>        &decisions,
                                Elasticity<dim>             &elasticity,
                                ContactSetup<dim>           &contact,
                                State                       &state,
                                TimerOutput                 &timer,
                                ConditionalOStream          &out,
                                std::function<StepVisitor()> watch)
    : in_place(decisions.scene, elasticity, contact, state, timer, std::move(watch))
    , decisions(decisions)
    , scene(decisions.scene)
    , elasticity(elasticity)
    , contact(contact)
    , state(state)
    , timer(timer)
    , out(out)
    , my_follows(elasticity.is_finite())
  {}



  template <int dim>
  void
  Equilibrium<dim>::set_state(const State &other, const bool follows)
  {
    state = other;
    earlier.reset();
    recall_bulk_stress();
    my_follows = follows;
    in_place.place(follows ? state.displacement : LA::Vector());
  }



  template <int dim>
  void
  Equilibrium<dim>::recall_bulk_stress()
  {
    BulkStress<dim> &bulk = elasticity.bulk_stress();
    bulk.set_coefficients(state.bulk_stress.size() > 0 ? state.bulk_stress : bulk.zero_vector());
  }



  template <int dim>
  void
  Equilibrium<dim>::forget_mesh()
  {
    in_place.forget_mesh();
    earlier.reset();
    state.bulk_stress = LA::Vector();
    if (my_follows)
      in_place.place(state.displacement);
    contact.forget_mesh();
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
            at.time,
            step};
  }



  template <int dim>
  Snapshot<dim>
  Equilibrium<dim>::snapshot(const unsigned int step) const
  {
    return snapshot(state, gap, in_place.contact_state(), active, step);
  }



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
    /// Is what was expected true, but for a small part of the change?
    bool
    goes_on(const LA::Vector &before, const LA::Vector &expected, const LA::Vector &now)
    {
      constexpr double small  = 0.1;
      LA::Vector       change = now, error = now;
      change -= before;
      error -= expected;
      return error.linfty_norm() <= small * change.linfty_norm() + 1e-12 * now.linfty_norm();
    }

    LA::Vector
    extrapolated(const LA::Vector &earlier, const LA::Vector &last, const double times)
    {
      LA::Vector result = last;
      result.sadd(1 + times, -times, earlier);
      return result;
    }
  } // namespace



  template <int dim>
  std::optional<LA::Vector>
  Equilibrium<dim>::predicted(const double t)
  {
    if (!elasticity.is_finite() || !earlier || t <= state.time)
      return {};
    // Only if supports and obstacles, and loads, go on as they did.
    const double times   = (t - state.time) / (state.time - earlier->time);
    const auto   load_at = [this](const double time) {
      elasticity.set_time(time);
      return elasticity.load();
    };
    const LA::Vector first = load_at(earlier->time), last = load_at(state.time), now = load_at(t);
    LA::Vector start = extrapolated(earlier->displacement, state.displacement, times), held = start;
    elasticity.distribute(held);
    if (!goes_on(state.displacement, start, held) ||
        !goes_on(last, extrapolated(first, last, times), now))
      return {};
    return start;
  }



  template <int dim>
  bool
  Equilibrium<dim>::solve_from(const std::optional<LA::Vector> &start,
                               const double                     t,
                               const double                     tolerance)
  {
    const State before = state;
    const bool  remembers =
      scene.contact.chosen().is_path_dependent() || !elasticity.material_history().empty();
    if (t > state.time && remembers)
      {
        state.start = {state.displacement, state.contact, state.material, t - state.time};
        in_place.start_step();
      }
    try
      {
        if (solve_from_start(start, t, tolerance))
          {
            state.time     = t;
            state.material = elasticity.internal_variables(state.displacement);
            if (elasticity.is_finite())
              {
                contact.check_passed(state.displacement, in_place.contact_state().pressure());
                my_report.curves_down = in_place.curves_down(state.displacement);
                my_report.jump        = jump_since(before);
                earlier.reset();
                if (t > before.time && my_report.jump == 0)
                  earlier = Earlier{before.displacement, before.time};
              }
            gap    = contact.gap_operator().gap(state.displacement);
            active = closed_points(in_place.contact_state().status);
            return true;
          }
      }
    catch (const SolverFailure &failure)
      {
        my_report        = NewtonReport();
        my_report.reason = failure.what();
        my_report.reason += contact.pressed_twice(closed_points(in_place.contact_state().status));
      }
    my_report.curves_down =
      elasticity.is_finite() && (in_place.has_curved_down() || curves_down_since(before));
    if (my_report.curves_down) // so may hierarchies
      in_place.release();
    keep_failure(t);
    state = before;
    in_place.recall_active_set();
    recall_bulk_stress();
    return false;
  }



  template <int dim>
  double
  Equilibrium<dim>::jump_since(const State &before)
  {
    constexpr double fast     = 3; // slower ones are no jumps
    const double     duration = state.time - before.time;
    if (duration == 0) // only the mesh is another
      return 0;
    LA::Vector way = state.displacement;
    way -= before.displacement;
    LA::Vector held = before.displacement;
    elasticity.distribute(held);
    held -= before.displacement;
    // What supports and obstacles are led along faster is none either.
    const double speed = way.l2_norm() / duration, drive = held.l2_norm() / duration,
                 pushed = last_drive > 0 ? std::max(1., drive / last_drive) : 1,
                 times  = last_speed > 0 && (drive == 0 || last_drive > 0) ?
                            speed / (last_speed * pushed) :
                            0;
    last_speed          = speed;
    last_drive          = drive;
    if (times <= fast)
      return 0;
    return curves_down_since(before) ? times : 0;
  }



  template <int dim>
  bool
  Equilibrium<dim>::curves_down_since(const State &before)
  {
    LA::Vector way = state.displacement;
    way -= before.displacement;
    if (way.linfty_norm() == 0)
      return false;
    for (const double share : {0.25, 0.5, 0.75})
      {
        LA::Vector between = before.displacement;
        between.add(share, way);
        if (in_place.curves_down(between))
          return true;
      }
    return false;
  }



  template <int dim>
  void
  Equilibrium<dim>::keep_failure(const double t)
  {
    my_failure                   = Failure{state,
                         contact.gap_operator().gap(state.displacement),
                         in_place.contact_state(),
                         closed_points(in_place.contact_state().status)};
    my_failure->state.time       = t;
    const LA::Vector &chattering = my_report.chattering;
    for (const auto i : chattering.locally_owned_elements())
      if (chattering(i) > 0)
        my_failure->active(i) = 2;
    my_failure->active.compress(VectorOperation::insert);
  }



  template <int dim>
  bool
  Equilibrium<dim>::solve_from_start(const std::optional<LA::Vector> &start,
                                     const double                     t,
                                     const double                     tolerance)
  {
    elasticity.set_time(t);
    const LA::Vector last = state.displacement;
    state.displacement    = start.value_or(last);
    in_place.go_on_from(state.displacement);
    elasticity.distribute(state.displacement);
    steps_before.clear();
    if (my_follows && t == state.time)
      return follow_surfaces(t, tolerance, !contact.is_outdated()); // only the mesh is another
    if (my_follows)
      {
        contact.check_ways(last, state.displacement);
        LA::Vector place = state.displacement;
        if (elasticity.is_finite()) // what supports move alone would fold surfaces
          {
            place = last;
            elasticity.set_rigid_motion(elasticity.rigid_motion(state.displacement), place);
          }
        in_place.place(std::move(place));
        in_place.find_contact(false);
      }
    else if (contact.is_outdated())
      in_place.find_contact(false);
    NewtonGoal goal = first_goal(tolerance, start.has_value());
    if (!my_follows && scene.contact.geometry == ContactGeometry::automatic)
      goal.is_enough = [this, was_asked = false]() mutable {
        return !std::exchange(was_asked, true) && leaves_place(false);
      };
    if (!solve_in_place(t, goal))
      return false;
    return leaves_place(true) ? follow_surfaces(t, tolerance, false) : true;
  }



  template <int dim>
  NewtonGoal
  Equilibrium<dim>::first_goal(const double tolerance, const bool is_predicted) const
  {
    // What the surfaces will change anyway need not be known to the last digit.
    const double enough = is_predicted                                                     ? 1e-1 :
                          elasticity.is_finite()                                           ? 1e-2 :
                          my_follows || scene.contact.geometry == ContactGeometry::updated ? 1e-3 :
                                                                                             0;
    return {std::max(tolerance, enough)};
  }



  template <int dim>
  NewtonGoal
  Equilibrium<dim>::next_goal(const double tolerance, const double before) const
  {
    // Augmentations take several steps each.
    if (scene.contact.chosen().predictor() == Predictor::last_pressure)
      return {elasticity.is_finite() ? std::max(tolerance, before > 0 ? 5e-3 * before : 1e-4) :
                                       tolerance};
    return {tolerance, 1};
  }



  template <int dim>
  bool
  Equilibrium<dim>::leaves_place(const bool is_solution)
  {
    const ContactGeometry wanted = scene.contact.geometry;
    if (my_follows)
      return true;
    if (wanted == ContactGeometry::automatic)
      {
        TimerOutput::Scope scope(timer, "contact geometry");
        if (const std::string unknown = contact.unknown_elsewhere(); !unknown.empty())
          {
            if (is_solution)
              out << "  contact geometry: reference, because the Gap of '" << unknown
                  << "' is defined on the undeformed surface only" << std::endl;
          }
        else
          {
            LA::Vector u = state.displacement;
            elasticity.distribute(u);
            const double change =
              contact.neglected(u, in_place.contact_state().pressure()).pressure;
            my_follows = change > decisions.geometry_tolerance();
            if (!my_follows && !is_solution)
              return false;
            my_neglected = change;
            out << "  contact geometry: updating it changes the pressure by about "
                << short_text(100 * change, 2) << " %"
                << (my_follows ? ": the contact geometry is updated from here on" : "")
                << std::endl;
          }
      }
    else
      my_follows = wanted == ContactGeometry::updated;
    return my_follows;
  }



  template <int dim>
  bool
  Equilibrium<dim>::follow_surfaces(const double t, const double tolerance, const bool is_placed)
  {
    const bool             is_finite = elasticity.is_finite();
    const unsigned int     most      = is_finite ? 40 : 20;
    const double           enough    = std::max(tolerance, scene.newton.of_geometry);
    constexpr unsigned int patience = 8, most_rules = 5;
    double                 before  = 0; // what was out of balance when surfaces were placed last
    double                 least   = std::numeric_limits<double>::max(); // of placements so far
    unsigned int           in_vain = 0;                                  // placements since then
    for (unsigned int n = 1; n <= most && in_vain < patience; ++n)
      {
        bool keeps_points = false;
        if (n > 1 || !is_placed)
          {
            // With small strain, points of integration stay where they are before long. With large
            // deformation results must not know from where they were reached: only if there is
            // nothing else, since points may go to and fro over kinks and rims.
            keeps_points =
              n > 1 && (is_finite ? in_vain > patience / 2 :
                                    n > most_rules || contact.has_settled(state.displacement));
            in_place.place(state.displacement);
            in_place.find_contact(true, keeps_points);
            steps_before = my_report.steps;
          }
        if (!solve_in_place(t, next_goal(tolerance, before), true))
          return false;
        const NewtonStep &first = my_report.steps[steps_before.size()];
        const double      now   = std::max(first.residual_of_bodies, first.gap_residual);
        // What is left after this solution is less than at the rate of the last two placements,
        // since it falls by second order, of which between the same points of integration an order
        // of 1.5 is counted on; forces of bodies feel up to ten times as much of it. Then forces of
        // pairs are told with the normals of this placement, to what was out of balance at it.
        // Large deformation may move the rims of two bodies past each other, which no tangent sees.
        const double rate = before > 0 ? now / before : 1;
        const bool   is_foreseen =
          !is_finite && rate <= 0.1 &&
          (now * rate <= 0.1 * enough ||
           (keeps_points && now <= 100 * enough && now * std::pow(rate, 1.5) <= 0.1 * enough));
        if (now <= enough || is_foreseen)
          {
            const NewtonStep &last = my_report.steps.back();
            if (!is_finite &&
                std::max({last.residual, last.residual_of_bodies, last.gap_residual}) <= tolerance)
              return true;
            if (!is_finite)
              steps_before = my_report.steps;
            return solve_in_place(t, {tolerance}, true);
          }
        before  = now;
        in_vain = now < least ? 0 : in_vain + 1;
        least   = std::min(least, now);
      }
    const bool by_segments =
      std::all_of(decisions.pairs.begin(), decisions.pairs.end(), [&](auto &pair) {
        return decisions.integration_of(pair).rule == Rule::segments;
      });
    const auto &[low, high] = elasticity.mesh().extent().get_boundary_points();
    constexpr double far    = 1e3; // sizes of the scene
    const bool       is_far = (low + (high - low) / 2).norm() > far * low.distance(high);
    my_report.converged     = false;
    my_report.reason =
      "the contact geometry update did not converge: " +
      std::string(
        is_far ?
          "the model lies so far from the origin that gaps are inaccurate by round-off: shift it to "
          "the origin, or set a larger Newton/Geometry tolerance, which is now " +
            short_text(scene.newton.of_geometry) + " of the forces; or " :
          "") +
      "use smaller load steps (Load steps/Number)" +
      (!is_finite   ? ", or set Contact method/Contact geometry = reference" :
       !by_segments ? ", or set Contact method/Integration = segments" :
                      "");
    return false;
  }



  template <int dim>
  bool
  Equilibrium<dim>::solve_in_place(const double t, const NewtonGoal &goal, const bool is_near)
  {
    const bool is_solved = in_place.solve(t, goal, is_near);
    my_report            = in_place.report();
    my_report.steps.insert(my_report.steps.begin(), steps_before.begin(), steps_before.end());
    return is_solved;
  }



  template class Equilibrium<2>;
  template class Equilibrium<3>;
} // namespace Signorini
