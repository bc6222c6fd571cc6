#include <signorini/body_setup.h>
#include <signorini/output/directory.h>
#include <signorini/output/preflight.h>
#include <signorini/parameters/text.h>
#include <signorini/simulation.h>
#include <signorini/solve/linear_reference.h>

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::string
    seconds(const double s)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(1) << s << " s";
      return text.str();
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const Scene<dim> &scene,
                              const MPI_Comm    comm,
                              std::ostream     &stream,
                              const bool        goes_on)
    : scene(scene)
    , comm(comm)
    , out(stream, Utilities::MPI::this_mpi_process(comm) == 0)
    // Each rank measures for itself: no barriers, and no waiting for ranks that have failed.
    , timer(MPI_COMM_SELF, out, TimerOutput::never, TimerOutput::wall_times)
    , goes_on(goes_on)
  {
    out << "Signorini " << SIGNORINI_VERSION << ": " << scene.name;
    if (!scene.title.empty())
      out << " - " << scene.title;
    out << "\n"
        << scene.contact.method << ", " << Utilities::MPI::n_mpi_processes(comm) << " ranks"
        << std::endl;
  }



  template <int dim>
  ExitCode
  Simulation<dim>::run()
  {
    if (goes_on)
      if (const auto code = code_of_finished_run())
        return *code;
    recorder     = std::make_unique<Recorder<dim>>(scene, clock, timer, comm, goes_on);
    interruption = std::make_unique<Interruption>(clock, 60 * scene.output.time_limit, comm);
    if (!recorder->note().empty())
      out << "  note: " << recorder->note() << std::endl;
    try
      {
        return solve_scene();
      }
    catch (const OutputError &)
      {
        throw; // the disk will not take that word either
      }
    catch (const std::exception &error)
      {
        recorder->stop(error.what());
        throw;
      }
  }



  template <int dim>
  ExitCode
  Simulation<dim>::solve_scene()
  {
    try
      {
        find_checkpoint();
        set_up();
        for (; position.cycle < scene.refinement.cycles; ++position.cycle)
          {
            build_contact(follows);
            report_set_up();
            reach();
            if (!solve_for_estimate())
              return finish();
            refine_mesh();
          }
        build_contact(follows);
        report_set_up();
        if (position.step > 0) // as it was between two load steps
          rows_of_places(state.contact, contact->gap_operator(), pressure, active);
        reach();
        run_load_history();
        if (report.converged && scene.output.linear_reference)
          compare_with_linear_solve();
      }
    catch (const SolverFailure &failure)
      {
        report.converged = false;
        report.reason    = failure.what();
      }
    catch (const Interrupted &interruption)
      {
        is_interrupted   = true;
        report.converged = false;
        report.reason    = interruption.what();
        if (!has_gained)
          report.reason += "; nothing was reached that a restart could start from";
      }
    return finish();
  }



  template <int dim>
  void
  Simulation<dim>::preflight()
  {
    only_checks = true;
    set_up();
    build_contact();
    report_set_up();
    out << "The scene is complete; nothing was solved." << std::endl;
  }



  template <int dim>
  void
  Simulation<dim>::set_up()
  {
    {
      TimerOutput::Scope scope(timer, "mesh");
      mesh = make_mesh(scene, comm);
      if (scene.auto_pairs)
        {
          scene.pairs      = automatic_pairs(scene, *mesh, out);
          scene.auto_pairs = false;
          scene.check_integration();
          // Contact surfaces are refined, and weigh more where the mesh is distributed.
          mesh = make_mesh(scene, comm);
        }
    }
    TimerOutput::Scope scope(timer, "setup");
    if (former)
      restore_mesh();
    elasticity = make_elasticity(scene, *mesh);
    elasticity->setup();
    state.displacement = elasticity->zero_vector();
    contact            = std::make_unique<ContactSetup<dim>>(scene, *elasticity, timer, out);
    if (former)
      restore_state();

    if (elasticity->has_free_motions() && scene.output.linear_reference)
      throw SceneError("Output/Linear reference: without contact nothing holds the bodies");
  }



  template <int dim>
  void
  Simulation<dim>::report_set_up()
  {
    out << "\nMesh " << position.cycle << ": " << elasticity->dof_handler().n_dofs()
        << " degrees of freedom, " << mesh->triangulation().n_global_active_cells() << " cells"
        << std::endl;
    if (recorder)
      recorder->add_sizes(*elasticity, *contact);
    if (position.cycle > 0 || is_restored)
      return;
    make_free_motions(); // refuses those that nothing stops
    check_wanted();
    TimerOutput::Scope scope(timer, "preflight");
    const Json         report = Signorini::preflight(
      scene, *elasticity, contact->surfaces(), contact->gap_operator(), clock.wall_time());
    std::ostringstream text;
    print_preflight(report, text, only_checks);
    out << text.str() << std::flush;
    if (recorder)
      recorder->add_preflight(report);
  }



  template <int dim>
  void
  Simulation<dim>::check_wanted()
  {
    // On a mesh that is to be refined, curved surfaces are not yet where they will be.
    const bool is_final = scene.refinement.cycles == 0;
    check_probes(*elasticity, scene.output.probes, is_final ? probe_tolerance : 0.5);
    if (scene.expected.empty())
      return;
    const LA::Vector nothing = contact->gap_operator().zero(),
                     gap     = contact->gap_operator().gap(state.displacement);
    const Snapshot<dim> start =
      snapshot(state.displacement, gap, nothing, nothing, scene.load_steps.ends().front(), 0);
    Json step =
      results_at(scene, start, is_final ? scene.output.probes : std::vector<Probe<dim>>());
    for (const char *number :
         {"time", "newton_iterations", "active_points", "residual", "multigrid_cycles"})
      step[number] = 0;
    std::vector<std::string> whole{"ranks",
                                   "dimension",
                                   "cycles",
                                   "load_steps",
                                   "cells",
                                   "dofs",
                                   "multiplier_dofs",
                                   "contact_faces",
                                   "contact_candidates",
                                   "contact_bytes",
                                   "seconds",
                                   "shares_of_ranks",
                                   "peak_memory_mb",
                                   "preflight",
                                   "linear_reference",
                                   "contact_geometry"};
    if (!is_final)
      whole.push_back("probes");
    check_paths(scene.expected, step, whole);
  }



  template <int dim>
  void
  Simulation<dim>::build_contact(const bool is_near, const bool keep_rule)
  {
    forget_newton();
    mesh_clock.start();
    contact->build(placed.size() > 0 ? Configuration<dim>(*elasticity, placed) :
                                       Configuration<dim>(*elasticity),
                   is_near,
                   keep_rule);
    rows_of_places(state.contact, contact->gap_operator(), pressure, active);
    active = contact->gap_operator().zero(); // the law finds it better: there may be more points
    mesh_clock.stop();
  }



  template <int dim>
  void
  Simulation<dim>::forget_newton()
  {
    if (newton)
      former_cycles += newton->multigrid_cycles();
    newton.reset(); // it refers to what is replaced
  }



  template <int dim>
  bool
  Simulation<dim>::solve(const double t, const double tolerance)
  {
    elasticity->set_time(t);
    elasticity->distribute(state.displacement);
    steps_before.clear();
    if (follows && t == state.time)
      return follow_surfaces(t, tolerance, true); // only the mesh is another
    if (follows)
      {
        placed = state.displacement;
        build_contact();
      }
    if (!solve_in_place(t, tolerance))
      return false;
    return follows || leaves_place() ? follow_surfaces(t, tolerance, false) : true;
  }



  template <int dim>
  bool
  Simulation<dim>::leaves_place()
  {
    const std::string &wanted = scene.contact.geometry;
    if (wanted == "automatic")
      {
        TimerOutput::Scope scope(timer, "contact geometry");
        if (const std::string unknown = contact->unknown_elsewhere(); !unknown.empty())
          out << "  contact geometry: that of surfaces at rest, since the Gap of '" << unknown
              << "' says nothing of other places" << std::endl;
        else
          {
            const double change = contact->neglected(state.displacement, pressure).pressure;
            follows             = change > scene.contact.geometry_share;
            recorder->add_contact_geometry(change, follows);
            out << "  contact geometry: surfaces as they are now change the pressure by about "
                << short_text(100 * change, 2) << " %"
                << (follows ? ": contact is found again there" : "") << std::endl;
          }
      }
    else
      {
        follows = wanted == "updated";
        recorder->add_contact_geometry({}, follows);
      }
    return follows;
  }



  template <int dim>
  bool
  Simulation<dim>::follow_surfaces(const double t, const double tolerance, const bool is_placed)
  {
    constexpr unsigned int most = 20, most_rules = 5;
    // What surfaces leave that are placed once more need not be solved for again.
    const double enough = std::max(tolerance, scene.newton.of_geometry);
    for (unsigned int n = 1; n <= most; ++n)
      {
        const bool keep_rule =
          n > 1 && (n > most_rules || contact->has_settled(state.displacement));
        if (n > 1 || !is_placed)
          {
            placed = state.displacement;
            build_contact(true, keep_rule);
            steps_before = report.steps;
          }
        if (!solve_in_place(t, n > 1 ? enough : tolerance, true))
          return false;
        const NewtonStep &first = report.steps[steps_before.size()];
        if (std::max(first.residual_of_bodies, first.gap_residual) <= enough &&
            (keep_rule || contact->has_settled(placed)))
          return true;
      }
    report.converged = false;
    report.reason =
      "contact on the surfaces as they are now does not come to rest: load in smaller steps (Load "
      "steps/Number), or take Contact method/Contact geometry = reference";
    return false;
  }



  template <int dim>
  bool
  Simulation<dim>::solve_in_place(const double t, const double tolerance, const bool is_near)
  {
    for (;;)
      {
        solve_with_candidates(t, tolerance);
        if (report.converged ? !contact->needs_more(state.displacement) :
                               !report.is_loose || !contact->look_farther())
          return report.converged;
        build_contact(is_near);
      }
  }



  template <int dim>
  FreeMotions
  Simulation<dim>::make_free_motions()
  {
    if (!elasticity->has_free_motions())
      return {};
    const auto make = [&] {
      return FreeMotions(elasticity->free_motions(),
                         elasticity->stabilising_springs(),
                         contact->gap_operator());
    };
    FreeMotions motions = make();
    while (!motions.never_held().empty() && contact->look_farther())
      {
        build_contact();
        motions = make();
      }
    if (!motions.never_held().empty() && scene.newton.undetermined == "refuse")
      throw SceneError("Supports/Names: no support holds " + join(motions.never_held()) +
                       ", and no contact can; " + NewtonSettings::how_to_hold() +
                       ". There are these boundaries: " + join(mesh->boundaries()) + ".");
    return motions;
  }



  template <int dim>
  void
  Simulation<dim>::make_newton(const double tolerance)
  {
    if (!assembled)
      {
        mesh_clock.start();
        TimerOutput::Scope scope(timer, "assembly");
        elasticity->assemble();
        assembled = true;
        mesh_clock.stop();
      }
    FreeMotions free_motions = make_free_motions(); // may search farther
    mesh_clock.start();
    if (!hierarchy)
      {
        TimerOutput::Scope scope(timer, "preconditioner");
        hierarchy = make_hierarchy(scene.solver,
                                   elasticity->stiffness(),
                                   elasticity->rigid_body_modes(),
                                   dim);
      }
    geometric.reset();
    if (placed.size() > 0)
      {
        TimerOutput::Scope scope(timer, "contact");
        geometric = std::make_unique<LA::SparseMatrix>(contact->geometric_stiffness(pressure));
      }
    NewtonSettings settings = scene.newton;
    settings.tolerance      = tolerance;
    newton                  = std::make_unique<Newton>(settings,
                                      scene.solver,
                                      scene.contact.chosen(),
                                      elasticity->stiffness(),
                                      elasticity->constraints(),
                                      contact->gap_operator(),
                                      hierarchy,
                                      elasticity->bodies_of_dofs(),
                                      dim,
                                      timer,
                                      std::move(free_motions),
                                      geometric.get());
    mesh_clock.stop();
  }



  template <int dim>
  void
  Simulation<dim>::solve_with_candidates(const double t, const double tolerance)
  {
    if (!newton)
      make_newton(tolerance);
    mesh_clock.start();
    LA::Vector f;
    {
      TimerOutput::Scope scope(timer, "assembly");
      f = elasticity->load();
    }
    // Forces of contact are linear about where it was looked for.
    if (geometric)
      {
        LA::Vector moved;
        moved.reinit(f);
        geometric->vmult(moved, placed);
        f -= moved;
      }
    elasticity->distribute(state.displacement);
    contact->set_time(t);
    report = newton->solve(f, state.displacement, pressure, active, watch());
    report.steps.insert(report.steps.begin(), steps_before.begin(), steps_before.end());
    elasticity->distribute(state.displacement);
    state.contact = places_of_rows(contact->gap_operator(), pressure, active, dim);
    mesh_clock.stop();
  }



  template <int dim>
  void
  Simulation<dim>::refine_mesh()
  {
    TimerOutput::Scope scope(timer, "estimate");
    newton.reset();
    hierarchy.reset();
    mesh_clock.reset();
    reached.reset(); // it belongs to the mesh
    assembled      = false;
    former_cycles  = 0;
    former_seconds = 0;
    const double estimate =
      refine(scene.refinement, *mesh, *elasticity, state.displacement, {&state.displacement});
    if (follows)
      placed = state.displacement;
    contact->forget_mesh();
    recorder->add_cycle(n_steps, estimate);
  }



  template <int dim>
  bool
  Simulation<dim>::solve_for_estimate()
  {
    // Only the end counts, and mostly it is found at once.
    const double tolerance = std::max(scene.newton.tolerance, scene.refinement.tolerance);
    const double end       = scene.load_steps.end_time;
    n_steps                = 0;
    if (attempt(end, tolerance))
      {
        n_steps = report.steps.size();
        return true;
      }
    if (report.is_loose || scene.load_steps.cut_backs == 0)
      return false;
    out << "  not solved at once (" << report.reason << "): step by step" << std::endl;
    state              = State();
    state.displacement = elasticity->zero_vector();
    state.contact      = SurfaceField(dim);
    pressure = active = contact->gap_operator().zero();
    Position start;
    start.longest = end / 2;
    return follow_loads(tolerance, start, [&](auto, auto) { n_steps += report.steps.size(); });
  }



  template <int dim>
  void
  Simulation<dim>::run_load_history()
  {
    follow_loads(scene.newton.tolerance, position, [&](const unsigned int step, const double t) {
      record_step(step, t);
      reach();
    });
  }



  template <int dim>
  bool
  Simulation<dim>::follow_loads(const double                                            tolerance,
                                Position                                               &from,
                                const std::function<void(unsigned int step, double t)> &visit)
  {
    const std::vector<double> ends    = scene.load_steps.ends();
    double                    start   = 0;
    auto &[cycle, t, number, longest] = from;
    for (const double end : ends)
      {
        const double smallest = (end - start) / std::pow(2, scene.load_steps.cut_backs);
        start                 = end;
        while (t < end)
          {
            const double next = end - t <= 1.001 * longest ? end : t + longest;
            if (ends.size() > 1 || next < end)
              out << "  load step " << number + 1 << ", t = " << next << std::endl;
            if (attempt(next, tolerance))
              {
                longest = std::max(longest, 2 * (next - t));
                t       = next;
                visit(++number, t);
              }
            else
              {
                longest = (next - t) / 2;
                if (longest < 0.999 * smallest || report.is_loose)
                  return false;
                out << "  not solved (" << report.reason << "): half the load step" << std::endl;
              }
          }
      }
    return true;
  }



  template <int dim>
  bool
  Simulation<dim>::attempt(const double t, const double tolerance)
  {
    const State before = state;
    try
      {
        if (solve(t, tolerance))
          {
            state.time = t;
            failure.reset();
            return true;
          }
      }
    catch (const SolverFailure &failure)
      {
        report        = NewtonReport();
        report.reason = failure.what();
        report.reason += contact->pressed_twice(active);
      }
    failure = Failure{t, state.displacement, pressure, active};
    for (const auto i : report.chattering.locally_owned_elements())
      failure->active(i) = report.chattering(i) > 0 ? 2 : active(i);
    failure->active.compress(VectorOperation::insert);
    state = before;
    rows_of_places(state.contact, contact->gap_operator(), pressure, active);
    return false;
  }



  template <int dim>
  void
  Simulation<dim>::record_step(const unsigned int step, const double t)
  {
    TimerOutput::Scope scope(timer, "output");
    const LA::Vector   gap = contact->gap_operator().gap(state.displacement);
    recorder->add_step(snapshot(state.displacement, gap, pressure, active, t, step),
                       report,
                       former_cycles + newton->multigrid_cycles());
  }



  template <int dim>
  void
  Simulation<dim>::record_failure()
  {
    if (!std::isfinite(failure->displacement.l2_norm() + failure->pressure.l2_norm()))
      return; // nothing to be drawn
    const LA::Vector gap = contact->gap_operator().gap(failure->displacement);
    recorder->add_failure(snapshot(failure->displacement,
                                   gap,
                                   failure->pressure,
                                   failure->active,
                                   failure->time,
                                   position.step + 1),
                          report);
  }



  template <int dim>
  Snapshot<dim>
  Simulation<dim>::snapshot(const LA::Vector  &displacement,
                            const LA::Vector  &gap,
                            const LA::Vector  &pressure,
                            const LA::Vector  &active,
                            const double       t,
                            const unsigned int step) const
  {
    return {*elasticity,
            scene.pairs,
            contact->surfaces(),
            contact->gap_operator(),
            displacement,
            gap,
            pressure,
            active,
            t,
            step};
  }



  template <int dim>
  double
  Simulation<dim>::mesh_seconds() const
  {
    return former_seconds + Utilities::MPI::max(mesh_clock.wall_time(), comm);
  }



  template <int dim>
  void
  Simulation<dim>::compare_with_linear_solve()
  {
    const double          seconds = mesh_seconds();
    const double          cycles  = former_cycles + newton->multigrid_cycles();
    const LinearReference linear  = [&]() {
      newton.reset(); // looks at the stiffness matrix
      TimerOutput::Scope scope(timer, "linear reference");
      return solve_without_contact(*elasticity, scene.solver, scene.newton.tolerance);
    }();
    recorder->add_linear_reference(linear, seconds, cycles);
  }



  template <int dim>
  ExitCode
  Simulation<dim>::finish()
  {
    recorder->add_sizes(*elasticity, *contact);
    std::ostringstream text;
    leave_checkpoint();
    if (failure && !report.converged && !is_interrupted)
      record_failure();
    const ExitCode code = recorder->finish(report, text, is_interrupted);
    if (report.converged) // after results.json has said so
      checkpoints->remove();
    out << text.str() << "\n"
        << seconds(clock.wall_time()) << ", results in " << recorder->directory()
        << "/results.json\n"
        << "Output directory: " << recorder->directory() << std::endl;
    return code;
  }



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace Signorini
