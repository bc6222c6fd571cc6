#include <signorini/output/preflight.h>
#include <signorini/output/summary.h>
#include <signorini/parameters/section.h>
#include <signorini/simulation.h>
#include <signorini/solve/linear_reference.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::unique_ptr<Mesh<dim>>
    make_mesh(const Scene<dim> &scene, const MPI_Comm comm)
    {
      std::vector<std::pair<std::string, BodyMesh<dim>>> bodies;
      for (const Body<dim> &body : scene.bodies)
        bodies.emplace_back(body.name, body.mesh);
      std::vector<std::pair<std::string, std::string>> contact_surfaces;
      for (const ContactPair<dim> &pair : scene.known_pairs())
        contact_surfaces.emplace_back(pair.slave, scene.obstacle_of(pair) ? "" : pair.master);
      return std::make_unique<Mesh<dim>>(bodies, scene.mesh, contact_surfaces, comm);
    }

    template <int dim>
    std::unique_ptr<Elasticity<dim>>
    make_elasticity(const Scene<dim> &scene, const Mesh<dim> &mesh)
    {
      std::vector<Material> materials;
      for (const Body<dim> &body : scene.bodies)
        materials.push_back(body.material);
      std::vector<RigidBody<dim>> rigid_bodies;
      for (const Obstacle<dim> &obstacle : scene.obstacles)
        if (obstacle.body.can_move())
          rigid_bodies.push_back(obstacle.body);
      return std::make_unique<Elasticity<dim>>(mesh,
                                               materials,
                                               scene.supports,
                                               scene.loads,
                                               scene.degrees(),
                                               model_of(scene.model),
                                               rigid_bodies,
                                               scene.newton.stabilisation);
    }

    std::string
    seconds(const double s)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(1) << s << " s";
      return text.str();
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const Scene<dim> &scene, const MPI_Comm comm)
    : scene(scene)
    , comm(comm)
    , out(std::cout, Utilities::MPI::this_mpi_process(comm) == 0)
    // Each rank measures for itself: no barriers, and no waiting for ranks that have failed.
    , timer(MPI_COMM_SELF, out, TimerOutput::never, TimerOutput::wall_times)
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
    const std::string directory =
      scene.output.directory.empty() ? "output/" + scene.name : scene.output.directory;
    writer = std::make_unique<Writer<dim>>(scene.output, directory, comm);
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      {
        std::ofstream resolved(directory + "/scene.prm");
        Section       section(resolved, false, 0, &scene.given);
        Scene<dim>(scene).declare(section);
      }
    results               = {{"scene", scene.name},
                             {"title", scene.title},
                             {"version", SIGNORINI_VERSION},
                             {"libraries", library_versions()},
                             {"ranks", Utilities::MPI::n_mpi_processes(comm)},
                             {"dimension", dim},
                             {"method", scene.contact.method},
                             {"converged", false},
                             {"reason", ""},
                             {"output_directory", directory}};
    results["cycles"]     = Json::array();
    results["load_steps"] = Json::array();
    try
      {
        set_up();
        for (unsigned int cycle = 0; cycle < scene.refinement.cycles; ++cycle)
          {
            build_contact();
            report_set_up();
            if (!solve_for_estimate())
              return finish();
            refine_mesh();
          }
        build_contact();
        report_set_up();
        run_load_history();
        if (report.converged && scene.output.linear_reference)
          compare_with_linear_solve();
      }
    catch (const SolverFailure &failure)
      {
        report.converged = false;
        report.reason    = failure.what();
      }
    return finish();
  }



  template <int dim>
  void
  Simulation<dim>::preflight()
  {
    set_up();
    build_contact();
    report_set_up();
    make_free_motions();
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
    elasticity = make_elasticity(scene, *mesh);
    elasticity->setup();
    displacement = elasticity->zero_vector();
    contact      = std::make_unique<ContactSetup<dim>>(scene, *elasticity, timer, out);

    if (elasticity->has_free_motions() && scene.output.linear_reference)
      throw SceneError("Output/Linear reference: without contact nothing holds the bodies");
  }



  template <int dim>
  void
  Simulation<dim>::report_set_up()
  {
    const unsigned int cycle = results["cycles"].size();
    out << "\nMesh " << cycle << ": " << elasticity->dof_handler().n_dofs()
        << " degrees of freedom, " << mesh->triangulation().n_global_active_cells() << " cells"
        << std::endl;
    if (cycle > 0)
      return;
    TimerOutput::Scope scope(timer, "preflight");
    const Json         report = Signorini::preflight(
      scene, *elasticity, contact->surfaces(), contact->gap_operator(), clock.wall_time());
    std::ostringstream text;
    print_preflight(report, text);
    out << text.str() << std::flush;
    results["preflight"] = report;
  }



  template <int dim>
  void
  Simulation<dim>::build_contact()
  {
    newton.reset(); // it refers to what is replaced here
    mesh_clock.restart();
    contact->build();
    // What a former mesh knew of the pressure.
    LA::Vector start = contact->gap_operator().zero();
    if (pressure.size() == elasticity->owned().size())
      contact->gap_operator().gather(pressure, start);
    pressure = start;
    mesh_clock.stop();
  }



  template <int dim>
  void
  Simulation<dim>::rebuild_contact()
  {
    pressure = nodal_pressure();
    build_contact();
  }



  template <int dim>
  bool
  Simulation<dim>::solve(const double t, const double tolerance)
  {
    for (;;)
      {
        solve_with_candidates(t, tolerance);
        if (report.converged ? !contact->needs_more(displacement) :
                               !report.is_loose || !contact->look_farther())
          return report.converged;
        rebuild_contact();
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
        rebuild_contact();
        motions = make();
      }
    if (!motions.never_held().empty() && scene.newton.undetermined == "refuse")
      throw SceneError("Supports/Names: no support holds " + join(motions.never_held()) +
                       ", and no contact can; " + NewtonSettings::how_to_hold());
    return motions;
  }



  template <int dim>
  void
  Simulation<dim>::solve_with_candidates(const double t, const double tolerance)
  {
    mesh_clock.start();
    elasticity->set_time(t);
    if (!newton)
      {
        if (!assembled)
          {
            TimerOutput::Scope scope(timer, "assembly");
            elasticity->assemble();
            assembled = true;
          }
        FreeMotions    free_motions = make_free_motions(); // may search farther
        NewtonSettings settings     = scene.newton;
        settings.tolerance          = tolerance;
        newton                      = std::make_unique<Newton>(settings,
                                          scene.solver,
                                          scene.contact.chosen(),
                                          elasticity->stiffness(),
                                          elasticity->constraints(),
                                          contact->gap_operator(),
                                          elasticity->rigid_body_modes(),
                                          dim,
                                          timer,
                                          std::move(free_motions));
      }
    LA::Vector f;
    {
      TimerOutput::Scope scope(timer, "assembly");
      f = elasticity->load();
    }
    elasticity->distribute(displacement);
    contact->set_interference(t);
    report = newton->solve(f, displacement, pressure, out);
    elasticity->distribute(displacement);
    mesh_clock.stop();
  }



  template <int dim>
  LA::Vector
  Simulation<dim>::nodal_pressure() const
  {
    LA::Vector nodal = elasticity->zero_vector();
    contact->gap_operator().scatter(pressure, nodal);
    elasticity->hanging_nodes().distribute(nodal);
    return nodal;
  }



  template <int dim>
  void
  Simulation<dim>::refine_mesh()
  {
    TimerOutput::Scope scope(timer, "estimate");
    LA::Vector         nodal = nodal_pressure();
    newton.reset();
    assembled = false;
    const double estimate =
      refine(scene.refinement, *mesh, *elasticity, displacement, {&displacement, &nodal});
    pressure = nodal;
    results["cycles"].push_back({{"newton_iterations", n_steps}, {"estimate", estimate}});
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
    displacement = elasticity->zero_vector();
    pressure     = contact->gap_operator().zero();
    if (newton)
      newton->set_active(pressure);
    return follow_loads(tolerance, end / 2, [&](auto, auto) { n_steps += report.steps.size(); });
  }



  template <int dim>
  void
  Simulation<dim>::run_load_history()
  {
    follow_loads(scene.newton.tolerance,
                 std::numeric_limits<double>::max(),
                 [&](const unsigned int step, const double t) { record_step(step, t); });
  }



  template <int dim>
  bool
  Simulation<dim>::follow_loads(const double                                            tolerance,
                                double                                                  longest,
                                const std::function<void(unsigned int step, double t)> &visit)
  {
    const std::vector<double> ends   = scene.load_steps.ends();
    double                    t      = 0;
    unsigned int              number = 0;
    for (const double end : ends)
      {
        const double smallest = (end - t) / std::pow(2, scene.load_steps.cut_backs);
        while (t < end)
          {
            const double next = end - t <= 1.001 * longest ? end : t + longest;
            if (ends.size() > 1 || next < end)
              out << "  load step " << number + 1 << ", t = " << next << std::endl;
            if (attempt(next, tolerance))
              {
                visit(++number, next);
                longest = std::max(longest, 2 * (next - t));
                t       = next;
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
    const LA::Vector u = displacement, p = pressure, nodal = nodal_pressure();
    const LA::Vector active = newton ? newton->active() : contact->gap_operator().zero();
    try
      {
        if (solve(t, tolerance))
          return true;
      }
    catch (const SolverFailure &failure)
      {
        report        = NewtonReport();
        report.reason = failure.what();
      }
    displacement         = u;
    const bool same_size = p.size() == pressure.size();
    pressure             = same_size ? p : contact->gap_operator().zero();
    if (!same_size)
      contact->gap_operator().gather(nodal, pressure);
    if (newton)
      newton->set_active(same_size ? active : contact->gap_operator().zero());
    return false;
  }



  template <int dim>
  void
  Simulation<dim>::record_step(const unsigned int step, const double t)
  {
    TimerOutput::Scope  scope(timer, "output");
    const LA::Vector    gap = contact->gap_operator().gap(displacement);
    const Snapshot<dim> now{*elasticity,
                            scene.pairs,
                            contact->surfaces(),
                            contact->gap_operator(),
                            displacement,
                            gap,
                            pressure,
                            newton->active(),
                            t,
                            step};

    Json         krylov = Json::array(), augmentations = Json::array();
    unsigned int before = 0;
    for (const NewtonStep &row : report.steps)
      {
        if (row.krylov_iterations > 0)
          krylov.push_back(row.krylov_iterations);
        if (row.augments)
          {
            augmentations.push_back(krylov.size() - before);
            before = krylov.size();
          }
      }
    Json one = {{"time", t},
                {"newton_iterations", krylov.size()},
                {"active_points", report.steps.back().active},
                {"residual", report.steps.back().residual},
                {"krylov_iterations", krylov},
                {"newton_iterations_before_augmentations", augmentations},
                {"multigrid_cycles", newton->multigrid_cycles()},
                {"pairs", pair_results(now)}};

    if (!report.undetermined.empty())
      one["held_motions"] = {{"names", report.undetermined},
                             {"largest_force", report.holding_force}};
    std::vector<bool> rigid;
    for (const ContactPair<dim> &pair : scene.pairs)
      rigid.push_back(scene.obstacle_of(pair) != nullptr);
    one.update(force_results(now, rigid));
    one["probes"]                  = probe_results(now, scene.output.probes);
    const SolutionErrors deviation = errors(now, scene.known);
    if (!scene.known.displacement.empty())
      {
        one["errors"]["displacement"] = deviation.displacement;
        one["errors"]["energy"]       = deviation.energy;
      }
    if (!scene.known.pressure.empty())
      one["errors"]["pressure"] = deviation.pressure;
    results["load_steps"].push_back(one);
    writer->write(now, scene.known.pressure);
  }



  template <int dim>
  void
  Simulation<dim>::compare_with_linear_solve()
  {
    const double          seconds = Utilities::MPI::max(mesh_clock.wall_time(), comm);
    const double          cycles  = newton->multigrid_cycles();
    const LinearReference linear  = [&]() {
      newton.reset(); // looks at the stiffness matrix
      TimerOutput::Scope scope(timer, "linear reference");
      return solve_without_contact(*elasticity, scene.solver, scene.newton.tolerance);
    }();
    results["linear_reference"] = {{"seconds",
                                    {{"assembly", linear.seconds_assembly},
                                     {"preconditioner", linear.seconds_preconditioner},
                                     {"krylov", linear.seconds_krylov}}},
                                   {"krylov_iterations", linear.iterations},
                                   {"near_null_space", linear.near_null_space},
                                   {"contact_seconds", seconds},
                                   {"contact_multigrid_cycles", cycles},
                                   {"R", seconds / linear.seconds()},
                                   {"W", cycles / linear.iterations}};
  }



  template <int dim>
  ExitCode
  Simulation<dim>::finish()
  {
    results["converged"]       = report.converged;
    results["reason"]          = report.reason;
    results["cells"]           = mesh->triangulation().n_global_active_cells();
    results["dofs"]            = elasticity->dof_handler().n_dofs();
    const GapOperator &gaps    = contact->gap_operator();
    results["multiplier_dofs"] = scene.contact.chosen().has_multipliers() ? gaps.weight.size() : 0;
    results["left_out"]        = contact->left_out();
    unsigned int faces = 0, candidates = 0;
    for (const ContactSurface<dim> &surface : contact->surfaces())
      {
        faces += surface.faces;
        candidates += surface.points.size();
      }
    results["contact_faces"]      = Utilities::MPI::sum(faces, comm);
    results["contact_candidates"] = Utilities::MPI::sum(candidates, comm);
    results["contact_bytes"]      = Utilities::MPI::sum(gaps.memory(), comm);

    results["seconds"]["total"] = Utilities::MPI::max(clock.wall_time(), comm);
    for (const auto &[name, time] : timer.get_summary_data(TimerOutput::total_wall_time))
      results["seconds"][name] = Utilities::MPI::max(time, comm);
    results["shares_of_ranks"] = shares_of_ranks(*elasticity, contact->surfaces());
    results["peak_memory_mb"]  = peak_memory(comm);

    const std::string directory = results["output_directory"];
    const std::string file      = directory + "/results.json";
    write_json(results, file, comm);

    ExitCode           code = report.converged ? solved : not_converged;
    std::ostringstream text;
    if (report.converged)
      {
        print_summary(results, text);
        if (!compare(scene.expected, results, text))
          code = missed;
        write_json(results, file, comm);
      }
    else
      text << "\nNot solved: " << report.reason << "\n";
    out << text.str();
    out << "\n"
        << seconds(results["seconds"]["total"]) << ", results in " << directory << "/results.json\n"
        << "Output directory: " << directory << std::endl;
    return code;
  }



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace Signorini
