#include "driver/equilibrium_in_place.h"

#include "base/interruption.h"
#include "contact/laws/contact_law.h"
#include "matrix_free/make_stiffness.h"
#include "solid/rigid_body_modes.h"
#include "solver/finite_bodies.h"
#include <signorini/base/text.h>
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  EquilibriumInPlace<dim>::EquilibriumInPlace(const Scene<dim>            &scene,
                                              Elasticity<dim>             &elasticity,
                                              ContactSetup<dim>           &contact,
                                              State                       &state,
                                              TimerOutput                 &timer,
                                              std::function<StepVisitor()> watch)
    : scene(scene)
    , elasticity(elasticity)
    , contact(contact)
    , state(state)
    , timer(timer)
    , watch(std::move(watch))
  {
    clock.reset();
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::find_contact(const bool is_near, const bool keeps_points)
  {
    forget_solver();
    clock.start();
    Configuration<dim> configuration =
      placed.size() > 0 ? Configuration<dim>(elasticity, placed) : Configuration<dim>(elasticity);
    if (placed.size() > 0 && scene.contact.chosen().needs_slip())
      configuration.set_start(state.start.displacement.size() > 0 ? state.start.displacement :
                                                                    placed);
    contact.build(configuration, is_near, keeps_points);
    recall_active_set();
    my_contact.status = contact.gap_operator().zero(); // the law finds it better: there may be more
    clock.stop();
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::recall_active_set()
  {
    my_contact = rows_of_places(state.contact, contact.gap_operator(), {});
    start_step();
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::start_step()
  {
    GapOperator &points = contact.gap_operator();
    my_contact.internal = InternalFields();
    if (scene.contact.chosen().is_path_dependent())
      my_contact.internal =
        rows_of_places(state.start.contact,
                       points,
                       scene.contact.chosen().make_law(points)->initial_fields())
          .internal;
    elasticity.material_history().start(state.start.material, state.start.duration);
    if (state.start.displacement.size() > 0)
      points.set_start(state.start.displacement);
  }



  template <int dim>
  bool
  EquilibriumInPlace<dim>::solve(const double t, const NewtonGoal &goal, const bool is_near)
  {
    for (;;)
      {
        look_for_interruption(); // behind each search
        solve_with_candidates(t, goal);
        if (my_report.converged ? !contact.needs_more(state.displacement) :
                                  !my_report.is_loose || !contact.look_farther())
          return my_report.converged;
        find_contact(is_near);
      }
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::solve_with_candidates(const double t, const NewtonGoal &goal)
  {
    if (!solver)
      make_solver();
    solver->newton.set_goal(goal);
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
    my_report = solver->newton.solve(state.displacement, my_contact, watch());
    elasticity.distribute(state.displacement);
    ContactState now  = my_contact;
    now.internal      = solver->newton.internal(state.displacement, my_contact);
    state.contact     = places_of_rows(contact.gap_operator(), now, dim);
    state.bulk_stress = elasticity.bulk_stress().coefficients();
    clock.stop();
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::make_solver()
  {
    if (!bodies)
      assemble();
    FreeMotions free_motions = make_free_motions(); // may search farther
    clock.start();
    if (!hierarchies)
      hierarchies.emplace(scene.solver, bodies->stiffness(), elasticity);
    contact.turn_forces(my_contact.traction);
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
  void
  EquilibriumInPlace<dim>::assemble()
  {
    clock.start();
    TimerOutput::Scope  scope(timer, "assembly");
    const StiffnessForm form =
      choose_form(scene.solver.stiffness_form, scene.solver.needs_matrix(), elasticity);
    if (elasticity.is_nonlinear())
      bodies =
        std::make_unique<FiniteBodies<dim>>(form, elasticity, bodies_of_dofs(elasticity), timer);
    else
      bodies = std::make_unique<LinearBodies>(make_stiffness(form, elasticity),
                                              elasticity.stabilising_springs(),
                                              elasticity.constraints(),
                                              bodies_of_dofs(elasticity),
                                              BulkBalance<dim>::create(elasticity));
    clock.stop();
  }



  template <int dim>
  FreeMotions
  EquilibriumInPlace<dim>::make_free_motions()
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
        find_contact(false);
        motions = make();
      }
    if (motions.never_held().empty() || scene.newton.undetermined != Undetermined::refuse)
      return motions;
    if (placed.size() > 0 && placed.linfty_norm() > 0) // on the way to somewhere else
      throw SolverFailure("in the current configuration contact cannot constrain " +
                          join(motions.never_held()) + "; use smaller load steps");
    throw SceneError("Supports/Names: no support constrains " + join(motions.never_held()) +
                     ", and no contact can; " + NewtonSettings::how_to_hold() +
                     ". Boundaries of the bodies: " + join(elasticity.mesh().boundaries()) + ".");
  }



  template <int dim>
  DualSolution
  EquilibriumInPlace<dim>::dual(const Functional &functional)
  {
    constexpr double   reduction = 1e-3; // what recovery makes of it is not better
    TimerOutput::Scope scope(timer, "dual");
    clock.start();
    const DualSolution result = solver->newton.dual(state.displacement,
                                                    my_contact,
                                                    functional.of_displacement,
                                                    functional.of_pressure,
                                                    reduction);
    clock.stop();
    return result;
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::forget_mesh()
  {
    solver.reset();
    hierarchies.reset();
    bodies.reset();
    clock.reset();
    former_cycles = 0;
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::release()
  {
    forget_solver();
    hierarchies.reset();
  }



  template <int dim>
  void
  EquilibriumInPlace<dim>::forget_solver()
  {
    had_curved_down = has_curved_down();
    if (solver)
      former_cycles += solver->linear_solver.multigrid_cycles();
    solver.reset(); // it refers to what is replaced
  }



  template class EquilibriumInPlace<2>;
  template class EquilibriumInPlace<3>;
} // namespace Signorini
