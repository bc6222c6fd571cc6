#include <signorini/contact/methods/method.h>
#include <signorini/elasticity/rigid_body_modes.h>
#include <signorini/equilibrium.h>
#include <signorini/matrix_free/make_stiffness.h>
#include <signorini/parameters/text.h>
#include <signorini/solve/finite_bodies.h>

#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Equilibrium<dim>::Equilibrium(const Scene<dim>            &scene,
                                Elasticity<dim>             &elasticity,
                                ContactSetup<dim>           &contact,
                                State                       &state,
                                TimerOutput                 &timer,
                                ConditionalOStream          &out,
                                std::function<StepVisitor()> watch)
    : scene(scene)
    , elasticity(elasticity)
    , contact(contact)
    , state(state)
    , timer(timer)
    , out(out)
    , watch(std::move(watch))
    , my_follows(elasticity.is_finite())
  {
    clock.reset();
  }



  template <int dim>
  void
  Equilibrium<dim>::find_contact()
  {
    build_contact(my_follows);
  }



  template <int dim>
  void
  Equilibrium<dim>::check_motions()
  {
    make_free_motions();
  }



  template <int dim>
  void
  Equilibrium<dim>::set_state(const State &other, const bool follows)
  {
    state = other;
    recall_bulk_stress();
    my_follows = follows;
    placed     = follows ? state.displacement : LA::Vector();
  }



  template <int dim>
  void
  Equilibrium<dim>::recall_active_set()
  {
    rows_of_places(state.contact, contact.gap_operator(), pressure, active);
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
    solver.reset();
    hierarchies.reset();
    bodies.reset();
    clock.reset();
    former_cycles     = 0;
    state.bulk_stress = LA::Vector();
    if (my_follows)
      placed = state.displacement;
    contact.forget_mesh();
  }



  template <int dim>
  void
  Equilibrium<dim>::release()
  {
    forget_solver();
    hierarchies.reset();
  }



  template <int dim>
  unsigned int
  Equilibrium<dim>::multigrid_cycles() const
  {
    return former_cycles + (solver ? solver->multigrid_cycles() : 0);
  }



  template <int dim>
  Snapshot<dim>
  Equilibrium<dim>::snapshot(const State       &at,
                             const LA::Vector  &gap,
                             const LA::Vector  &pressure,
                             const LA::Vector  &active,
                             const unsigned int step) const
  {
    return {elasticity,
            scene.pairs,
            contact.surfaces(),
            contact.gap_operator(),
            at.displacement,
            gap,
            pressure,
            active,
            at.time,
            step};
  }



  template <int dim>
  Snapshot<dim>
  Equilibrium<dim>::snapshot(const unsigned int step) const
  {
    return snapshot(state, gap, pressure, active, step);
  }



  template <int dim>
  std::optional<Snapshot<dim>>
  Equilibrium<dim>::failure(const unsigned int step) const
  {
    if (!my_failure ||
        !std::isfinite(my_failure->state.displacement.l2_norm() + my_failure->pressure.l2_norm()))
      return {};
    return snapshot(
      my_failure->state, my_failure->gap, my_failure->pressure, my_failure->active, step);
  }



  template <int dim>
  DualSolution
  Equilibrium<dim>::dual(const Functional &functional)
  {
    constexpr double   reduction = 1e-3; // what recovery makes of it is not better
    TimerOutput::Scope scope(timer, "dual");
    clock.start();
    const DualSolution result = solver->dual(state.displacement,
                                             pressure,
                                             active,
                                             functional.of_displacement,
                                             functional.of_pressure,
                                             reduction);
    clock.stop();
    return result;
  }



  template <int dim>
  bool
  Equilibrium<dim>::solve(const double t, const double tolerance)
  {
    const State before = state;
    my_failure.reset();
    try
      {
        if (solve_from_state(t, tolerance))
          {
            state.time = t;
            if (elasticity.is_finite())
              my_report.curves_down = solver->curves_down(state.displacement);
            gap = contact.gap_operator().gap(state.displacement);
            return true;
          }
      }
    catch (const SolverFailure &failure)
      {
        my_report        = NewtonReport();
        my_report.reason = failure.what();
        my_report.reason += contact.pressed_twice(active);
      }
    keep_failure(t);
    state = before;
    recall_active_set();
    recall_bulk_stress();
    return false;
  }



  template <int dim>
  void
  Equilibrium<dim>::keep_failure(const double t)
  {
    my_failure = Failure{state, contact.gap_operator().gap(state.displacement), pressure, active};
    my_failure->state.time       = t;
    const LA::Vector &chattering = my_report.chattering;
    for (const auto i : chattering.locally_owned_elements())
      my_failure->active(i) = chattering(i) > 0 ? 2 : active(i);
    my_failure->active.compress(VectorOperation::insert);
  }



  template <int dim>
  bool
  Equilibrium<dim>::solve_from_state(const double t, const double tolerance)
  {
    elasticity.set_time(t);
    left = state.displacement;
    elasticity.distribute(state.displacement);
    steps_before.clear();
    if (my_follows && t == state.time)
      return follow_surfaces(t, tolerance, true); // only the mesh is another
    if (my_follows)
      {
        placed = state.displacement;
        if (elasticity.is_finite()) // what supports move alone would fold surfaces
          {
            placed = left;
            elasticity.set_rigid_motion(elasticity.rigid_motion(state.displacement), placed);
          }
        build_contact();
      }
    if (!solve_in_place(t, first_goal(tolerance)))
      return false;
    return my_follows || leaves_place() ? follow_surfaces(t, tolerance, false) : true;
  }



  template <int dim>
  NewtonGoal
  Equilibrium<dim>::first_goal(const double tolerance) const
  {
    // What the surfaces will change anyway need not be known to the last digit.
    const double enough = elasticity.is_finite()                                           ? 1e-2 :
                          my_follows || scene.contact.geometry == ContactGeometry::updated ? 1e-5 :
                                                                                             0;
    return {std::max(tolerance, enough)};
  }



  template <int dim>
  NewtonGoal
  Equilibrium<dim>::next_goal(const double tolerance, const double before) const
  {
    if (!elasticity.is_finite())
      return {tolerance};
    // Augmentations take several steps each.
    if (scene.contact.chosen().predictor() == Predictor::last_pressure)
      return {std::max(tolerance, before > 0 ? 5e-3 * before : 1e-4)};
    return {tolerance, 1};
  }



  template <int dim>
  bool
  Equilibrium<dim>::leaves_place()
  {
    const ContactGeometry wanted = scene.contact.geometry;
    if (wanted == ContactGeometry::automatic)
      {
        TimerOutput::Scope scope(timer, "contact geometry");
        if (const std::string unknown = contact.unknown_elsewhere(); !unknown.empty())
          out << "  contact geometry: that of surfaces at rest, since the Gap of '" << unknown
              << "' says nothing of other places" << std::endl;
        else
          {
            const double change = contact.neglected(state.displacement, pressure).pressure;
            my_follows          = change > scene.contact.geometry_share;
            my_neglected        = change;
            out << "  contact geometry: surfaces as they are now change the pressure by about "
                << short_text(100 * change, 2) << " %"
                << (my_follows ? ": contact is found again there" : "") << std::endl;
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
        if (n > 1 || !is_placed)
          {
            // With small strain, points of integration stay where they are before long. With large
            // deformation results must not know from where they were reached: only if there is
            // nothing else, since points may go to and fro over kinks and rims.
            const bool keeps_points =
              n > 1 && (is_finite ? in_vain > patience / 2 :
                                    n > most_rules || contact.has_settled(state.displacement));
            placed = state.displacement;
            build_contact(true, keeps_points);
            steps_before = my_report.steps;
          }
        if (!solve_in_place(t, next_goal(tolerance, before), true))
          return false;
        const NewtonStep &first = my_report.steps[steps_before.size()];
        const double      now   = std::max(first.residual_of_bodies, first.gap_residual);
        // What is left after this solution is less than at the rate of the last two placements,
        // since it falls by second order; forces of bodies feel up to ten times as much of it.
        // Large deformation may move the rims of two bodies past each other, which no tangent sees.
        const bool is_foreseen =
          !is_finite && now <= 0.1 * before && now * now <= 0.1 * enough * before;
        if (now <= enough || is_foreseen)
          return !is_finite || solve_in_place(t, {tolerance}, true);
        before  = now;
        in_vain = now < least ? 0 : in_vain + 1;
        least   = std::min(least, now);
      }
    my_report.converged = false;
    my_report.reason =
      "contact on the surfaces as they are now does not come to rest: load in smaller steps (Load steps/Number)" +
      std::string(elasticity.is_finite() ?
                    ", or integrate by segments (Contact method/Integration)" :
                    ", or take Contact method/Contact geometry = reference");
    return false;
  }



  template <int dim>
  bool
  Equilibrium<dim>::solve_in_place(const double t, const NewtonGoal &goal, const bool is_near)
  {
    for (;;)
      {
        solve_with_candidates(t, goal);
        if (my_report.converged ? !contact.needs_more(state.displacement) :
                                  !my_report.is_loose || !contact.look_farther())
          return my_report.converged;
        build_contact(is_near);
      }
  }



  template <int dim>
  void
  Equilibrium<dim>::solve_with_candidates(const double t, const NewtonGoal &goal)
  {
    if (!solver)
      make_solver();
    solver->set_goal(goal);
    clock.start();
    {
      TimerOutput::Scope scope(timer, "assembly");
      LA::Vector         f = elasticity.load();
      if (placed.size() > 0)
        elasticity.turn_moments(elasticity.rigid_motion(placed), f);
      bodies->set_load(std::move(f));
      if (left.size() > 0)
        bodies->start_from(std::exchange(left, LA::Vector()));
    }
    elasticity.distribute(state.displacement);
    contact.set_time(t);
    my_report = solver->solve(state.displacement, pressure, active, watch());
    my_report.steps.insert(my_report.steps.begin(), steps_before.begin(), steps_before.end());
    elasticity.distribute(state.displacement);
    state.contact     = places_of_rows(contact.gap_operator(), pressure, active, dim);
    state.bulk_stress = elasticity.bulk_stress().coefficients();
    clock.stop();
  }



  template <int dim>
  void
  Equilibrium<dim>::make_solver()
  {
    if (!bodies)
      assemble();
    FreeMotions free_motions = make_free_motions(); // may search farther
    clock.start();
    if (!hierarchies)
      hierarchies.emplace(solver_settings(), bodies->stiffness(), elasticity);
    contact.turn_forces(pressure);
    solver = std::make_unique<ContactSolver>(scene.newton,
                                             scene.solver,
                                             scene.contact.chosen(),
                                             *bodies,
                                             contact.gap_operator(),
                                             std::move(free_motions),
                                             *hierarchies,
                                             timer);
    clock.stop();
  }



  template <int dim>
  LinearSolverSettings
  Equilibrium<dim>::solver_settings() const
  {
    LinearSolverSettings result = scene.solver;
    if (elasticity.is_finite()) // coarser spaces know the stiffness at rest alone
      result.coarsening = Coarsening::algebraic;
    return result;
  }



  template <int dim>
  void
  Equilibrium<dim>::assemble()
  {
    clock.start();
    TimerOutput::Scope scope(timer, "assembly");
    if (elasticity.is_finite())
      {
        elasticity.assemble();
        bodies = std::make_unique<FiniteBodies<dim>>(elasticity, bodies_of_dofs(elasticity), timer);
      }
    else
      bodies =
        std::make_unique<LinearBodies>(make_stiffness(choose_form(scene.solver.stiffness_form,
                                                                  scene.solver.needs_matrix(),
                                                                  elasticity),
                                                      elasticity),
                                       elasticity.stabilising_springs(),
                                       elasticity.constraints(),
                                       bodies_of_dofs(elasticity),
                                       BulkBalance<dim>::create(elasticity));
    clock.stop();
  }



  template <int dim>
  FreeMotions
  Equilibrium<dim>::make_free_motions()
  {
    if (!elasticity.has_free_motions())
      return {};
    const auto make = [&] {
      return FreeMotions(elasticity.free_motions(),
                         elasticity.stabilising_springs(),
                         contact.gap_operator());
    };
    FreeMotions motions = make();
    while (!motions.never_held().empty() && contact.look_farther())
      {
        build_contact();
        motions = make();
      }
    if (motions.never_held().empty() || scene.newton.undetermined != Undetermined::refuse)
      return motions;
    if (placed.size() > 0 && placed.linfty_norm() > 0) // on the way to somewhere else
      throw SolverFailure("where surfaces are now, no contact can hold " +
                          join(motions.never_held()) + "; load in smaller steps");
    throw SceneError("Supports/Names: no support holds " + join(motions.never_held()) +
                     ", and no contact can; " + NewtonSettings::how_to_hold() +
                     ". There are these boundaries: " + join(elasticity.mesh().boundaries()) + ".");
  }



  template <int dim>
  void
  Equilibrium<dim>::build_contact(const bool is_near, const bool keeps_points)
  {
    forget_solver();
    clock.start();
    contact.build(placed.size() > 0 ? Configuration<dim>(elasticity, placed) :
                                      Configuration<dim>(elasticity),
                  is_near,
                  keeps_points);
    rows_of_places(state.contact, contact.gap_operator(), pressure, active);
    active = contact.gap_operator().zero(); // the law finds it better: there may be more points
    clock.stop();
  }



  template <int dim>
  void
  Equilibrium<dim>::forget_solver()
  {
    if (solver)
      former_cycles += solver->multigrid_cycles();
    solver.reset(); // it refers to what is replaced
  }



  template class Equilibrium<2>;
  template class Equilibrium<3>;
} // namespace Signorini
