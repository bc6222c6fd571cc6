// SPDX-License-Identifier: Apache-2.0
#include "driver/fixed_configuration_solver.h"

#include "base/interruption.h"
#include "contact/laws/coulomb_friction.h"
#include "fields/friction_fields.h"
#include "matrix_free/make_stiffness.h"
#include "solid/rigid_body_modes.h"
#include "solver/nonlinear_solid.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  FixedConfigurationSolver<dim>::FixedConfigurationSolver(const Scene<dim>            &scene,
                                                          Elasticity<dim>             &elasticity,
                                                          ContactInterfaces<dim>      &contact,
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



  // Search contact in the set configuration, assemble the gap operator, and restore pressures and
  // internal variables from the state. The solver of the former gap operator is discarded; solids
  // and hierarchies are kept.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::find_contact(const bool is_near,
                                              const bool keeps_integration_points)
  {
    reset_solver();
    clock.start();
    Configuration<dim> configuration =
      configuration_displacement.size() > 0 ?
        Configuration<dim>(elasticity, configuration_displacement) :
        Configuration<dim>(elasticity);
    if (configuration_displacement.size() > 0 && scene.contact.chosen().uses_slip())
      configuration.set_start(state.start.displacement.size() > 0 ? state.start.displacement :
                                                                    configuration_displacement);
    contact.build(configuration, is_near, keeps_integration_points);
    restore_active_set();
    // The status is left empty: the law determines it from trial tractions, since there may be
    // additional points.
    my_contact.status = contact.gap_operator().zero();
    clock.stop();
  }



  template <int dim>
  void
  FixedConfigurationSolver<dim>::restore_active_set()
  {
    my_contact = from_surface_field(state.contact, contact.gap_operator(), {});
    start_step();
  }



  // Internal variables of contact and materials are those at the start of the load step, and slip
  // is measured from there.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::start_step()
  {
    GapOperator &points = contact.gap_operator();
    my_contact.internal = InternalFields();
    if (scene.contact.chosen().is_path_dependent())
      my_contact.internal =
        from_surface_field(state.start.contact,
                           points,
                           scene.contact.chosen().make_law(points)->initial_fields())
          .internal;
    if (scene.contact.chosen().has_strength)
      {
        // Bonds that have failed in this load step stay so when contact is searched for again.
        // Points that were not found then have no bond; at first all have one.
        LA::Vector &intact = my_contact.internal.scalars[CoulombFriction::bond];
        const bool  is_first =
          Utilities::MPI::max(state.contact.empty() ? 0 : 1, elasticity.mesh().communicator()) == 0;
        if (is_first)
          intact = 1;
        else
          intact = from_surface_field(state.contact, points, my_contact.internal)
                     .internal.scalars[CoulombFriction::bond];
        contact.set_bonds(intact);
      }
    // The first search of the load step counts, whose surfaces are those at its start.
    if (scene.contact.chosen().has_late_ties && state.start.displacement.size() > 0 &&
        contact.set_gaps_at_start(state.start.displacement, my_contact.internal))
      {
        ContactState start  = from_surface_field(state.start.contact, points, my_contact.internal);
        start.internal      = my_contact.internal;
        state.start.contact = to_surface_field(points, start, dim);
      }
    elasticity.material_history().start(state.start.material, state.start.duration);
    if (state.start.displacement.size() > 0)
      points.set_start(state.start.displacement);
  }



  // Solve, and repeat with enlarged candidates while surfaces may have come closer than the search
  // radius, or while bodies without sufficient supports may find contact farther away. Each
  // repetition enlarges the radius of a pair beyond the motion of the solution before, or up to the
  // size of the model. Collective.
  template <int dim>
  bool
  FixedConfigurationSolver<dim>::solve(const double            t,
                                       const StoppingCriteria &stopping,
                                       const bool              is_near)
  {
    for (;;)
      {
        // Each search may have taken long.
        check_for_interruption();
        solve_with_candidates(t, stopping);
        if (my_report.converged ?
              !contact.search_radius_exceeded(state.displacement) :
              !my_report.has_unconstrained_modes || !contact.enlarge_search_radius())
          return my_report.converged;
        find_contact(is_near);
      }
  }



  // One solution with Newton's method on the present candidates: load vector, prescribed
  // displacements and gap data at time t, then the solution is stored in the state as a surface
  // field.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::solve_with_candidates(const double            t,
                                                       const StoppingCriteria &stopping)
  {
    if (!solver)
      make_solver();
    solver->newton.set_stopping_criteria(stopping);
    clock.start();
    {
      TimerOutput::Scope scope(timer, "assembly");
      LA::Vector         f = elasticity.load();
      // Moments on rotated bodies, see Elasticity::rotate_moments().
      if (configuration_displacement.size() > 0)
        elasticity.rotate_moments(elasticity.rigid_motion(configuration_displacement), f);
      bodies->set_load(std::move(f));
      if (initial_guess.size() > 0)
        bodies->extrapolate_from(std::exchange(initial_guess, LA::Vector()));
    }
    elasticity.distribute(state.displacement);
    contact.set_time(t, my_contact.internal);
    my_report = solver->newton.solve(state.displacement, my_contact, watch());
    elasticity.distribute(state.displacement);
    if (my_report.converged && scene.contact.chosen().has_friction)
      contact.check_friction(t, my_contact.internal, my_contact.pressure());
    my_contact.internal_at_end = solver->newton.internal(state.displacement, my_contact);
    if (scene.contact.chosen().has_friction)
      {
        forget_slip_without_pressure();
        stick_without_slip();
      }
    store_contact();
    state.volumetric_stress = elasticity.volumetric_stress().coefficients();
    clock.stop();
  }



  template <int dim>
  void
  FixedConfigurationSolver<dim>::store_contact()
  {
    ContactState now = my_contact;
    now.internal     = now.internal_at_end;
    state.contact    = to_surface_field(contact.gap_operator(), now, dim);
  }



  // The solver is made anew, since the rigid-body modes that ties have constrained may be free.
  template <int dim>
  bool
  FixedConfigurationSolver<dim>::break_bonds()
  {
    if (!scene.contact.chosen().has_strength ||
        !contact.break_bonds(my_contact.traction,
                             my_contact.internal.scalars[CoulombFriction::bond]))
      return false;
    my_contact.internal_at_end.scalars[CoulombFriction::bond] =
      my_contact.internal.scalars[CoulombFriction::bond];
    store_contact();
    reset_solver();
    return true;
  }



  // Surfaces that just touch, with pressures of the size of rounding, have no friction, and count
  // no slip, as if they were open: rounding must not decide from where it counts. Tied ones stick
  // without pressure.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::forget_slip_without_pressure()
  {
    const double rounding =
      rounding_of_pressure(elasticity.mesh().size(), contact.gap_operator(), state.displacement);
    InternalFields       &after  = my_contact.internal_at_end;
    const InternalFields &before = my_contact.internal;
    for (const auto i : my_contact.pressure().locally_owned_elements())
      if (std::abs(my_contact.pressure()(i)) <= rounding &&
          status_of(contact.gap_operator().coefficients.least_status(i)) != ContactStatus::stick)
        {
          for (PointVectors &vector : after.vectors)
            for (LA::Vector &component : vector)
              component(i) = 0;
          for (unsigned int k = 0; k < after.scalars.size(); ++k)
            after.scalars[k](i) = before.scalars.empty() ? 0. : double(before.scalars[k](i));
        }
    after.compress();
  }



  // A point that slipped before may rest on the bound of friction without slipping: its trial
  // traction is on the rim of the disc, and rounding decides its status. Slips are compared with
  // the largest one of the pair in the load step.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::stick_without_slip()
  {
    const GapOperator    &operators = contact.gap_operator();
    const InternalFields &after = my_contact.internal_at_end, &before = my_contact.internal;
    if (after.scalars.size() < 2)
      return;
    const auto slip = [&](const auto i) {
      return after.scalars[1](i) - (before.scalars.empty() ? 0. : double(before.scalars[1](i)));
    };
    constexpr double    negligible = 1e-6, rounding = 1e-12;
    std::vector<double> largest(operators.n_pairs(),
                                rounding / negligible * elasticity.mesh().size());
    operators.for_each_point([&](const auto i, const unsigned int pair) {
      largest[pair] = std::max(largest[pair], slip(i));
    });
    Utilities::MPI::max(largest, elasticity.mesh().communicator(), largest);
    operators.for_each_point([&](const auto i, const unsigned int pair) {
      if (status_of(my_contact.status(i)) == ContactStatus::slip &&
          operators.coefficients.friction(i) > 0 && slip(i) <= negligible * largest[pair])
        my_contact.status(i) = static_cast<double>(ContactStatus::stick);
    });
    my_contact.status.compress(VectorOperation::insert);
  }



  // Make what does not exist yet: the solid's residual and stiffness, its hierarchy, the geometric
  // stiffness for the last tractions, and the solver.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::make_solver()
  {
    if (!bodies)
      assemble();
    // This may search contact again with a larger radius.
    UnconstrainedModes unconstrained_modes = make_unconstrained_modes();
    clock.start();
    if (!hierarchies)
      hierarchies.emplace(scene.solver, bodies->stiffness(), elasticity);
    contact.build_geometric_stiffness(my_contact.traction);
    solver = std::make_unique<ContactSolver>(scene.newton,
                                             scene.solver,
                                             scene.contact.chosen(),
                                             *bodies,
                                             contact.gap_operator(),
                                             std::move(unconstrained_modes),
                                             *hierarchies,
                                             timer);
    clock.stop();
  }



  // The residual of the bodies: nonlinear if any material has a constitutive law; assembled or
  // matrix-free stiffness.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::assemble()
  {
    clock.start();
    TimerOutput::Scope  scope(timer, "assembly");
    const StiffnessForm form =
      choose_form(scene.solver.stiffness_form, scene.solver.traits().needs_matrix, elasticity);
    if (elasticity.is_nonlinear())
      bodies =
        std::make_unique<NonlinearSolid<dim>>(form, elasticity, bodies_of_dofs(elasticity), timer);
    else
      bodies = std::make_unique<LinearElasticSolid>(make_stiffness(form, elasticity),
                                                    elasticity.stabilising_stiffness(),
                                                    elasticity.constraints(),
                                                    bodies_of_dofs(elasticity),
                                                    VolumeConstraint<dim>::create(elasticity));
    clock.stop();
  }



  // The unconstrained rigid-body modes, after enlarging the search radius while some of them could
  // not be constrained by the candidates. Throws if that remains so: SolverFailure in a displaced
  // configuration, where smaller load steps may help, otherwise SceneError.
  template <int dim>
  UnconstrainedModes
  FixedConfigurationSolver<dim>::make_unconstrained_modes()
  {
    if (!elasticity.has_unsupported_modes())
      return {};
    const auto make = [&] {
      return UnconstrainedModes(elasticity.unconstrained_modes(),
                                elasticity.stabilising_stiffness(),
                                contact.gap_operator());
    };
    UnconstrainedModes motions = make();
    while (!motions.unconstrainable().empty() && contact.enlarge_search_radius())
      {
        find_contact(false);
        motions = make();
      }
    if (motions.unconstrainable().empty() ||
        scene.newton.undetermined_modes != UnconstrainedModeTreatment::refuse)
      return motions;
    if (configuration_displacement.size() > 0 && configuration_displacement.linfty_norm() > 0)
      throw SolverFailure("in the current configuration contact cannot constrain " +
                          join(motions.unconstrainable()) + "; use smaller load steps");
    throw SceneError("Supports/Names: no support constrains " + join(motions.unconstrainable()) +
                     ", and no contact can; " + NewtonSettings::stabilisation_advice() +
                     ". Boundaries of the bodies: " + join(elasticity.mesh().boundaries()) + ".");
  }



  // Solve the dual problem of a quantity with the transposed linearisation at the solution
  // (doc/theory, 8.1). Collective.
  template <int dim>
  DualSolution
  FixedConfigurationSolver<dim>::dual(const Functional &functional)
  {
    // Recovered stresses and error estimates are not more accurate than this.
    constexpr double   reduction = 1e-3;
    TimerOutput::Scope scope(timer, "dual");
    clock.start();
    const DualSolution result = solver->newton.dual(state.displacement,
                                                    my_contact,
                                                    functional.of_displacement,
                                                    functional.of_volumetric_stress,
                                                    functional.of_traction,
                                                    reduction);
    clock.stop();
    return result;
  }



  template <int dim>
  void
  FixedConfigurationSolver<dim>::invalidate()
  {
    solver.reset();
    hierarchies.reset();
    bodies.reset();
    clock.reset();
    former_cycles = 0;
  }



  template <int dim>
  void
  FixedConfigurationSolver<dim>::release()
  {
    reset_solver();
    hierarchies.reset();
  }



  // Keep what must outlive the solver: whether its tangent was indefinite, and the count of cycles.
  template <int dim>
  void
  FixedConfigurationSolver<dim>::reset_solver()
  {
    had_negative_curvature = met_negative_curvature();
    if (solver)
      former_cycles += solver->linear_solver.multigrid_cycles();
    // The solver refers to the gap operator and the solids that are replaced next.
    solver.reset();
  }



  template class FixedConfigurationSolver<2>;
  template class FixedConfigurationSolver<3>;
} // namespace Signorini
