#include <signorini/output/summary.h>
#include <signorini/parameters/section.h>
#include <signorini/simulation.h>
#include <signorini/solve/linear_reference.h>

#include <fstream>
#include <iomanip>
#include <iostream>
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
      for (const ContactPair<dim> &pair : scene.pairs)
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
      return std::make_unique<Elasticity<dim>>(
        mesh, materials, scene.supports, scene.loads, scene.degree);
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
        Section       section(resolved, false);
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
            report_set_up();
            build_contact();
            if (!solve(scene.load_steps.end_time,
                       std::max(scene.newton.tolerance, scene.refinement.tolerance)))
              return finish();
            refine_mesh();
          }
        report_set_up();
        build_contact();
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
    report_set_up();
    build_contact();
    out << "The scene is complete; nothing was solved." << std::endl;
  }



  template <int dim>
  void
  Simulation<dim>::set_up()
  {
    {
      TimerOutput::Scope scope(timer, "mesh");
      mesh = make_mesh(scene, comm);
    }
    TimerOutput::Scope scope(timer, "setup");
    elasticity = make_elasticity(scene, *mesh);
    elasticity->setup();
    displacement = elasticity->zero_vector();

    const auto floating = elasticity->unrestrained_modes();
    if (!floating.empty())
      throw SceneError(
        "Supports/Names: no support holds " + join(floating) +
        "; bodies that contact alone holds cannot be solved yet: prescribe a displacement that stops these motions");
  }



  template <int dim>
  void
  Simulation<dim>::report_set_up()
  {
    std::vector<unsigned long> cells(mesh->n_bodies());
    for (const auto &cell : mesh->triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        ++cells[cell->material_id()];
    Utilities::MPI::sum(cells, comm, cells);
    out << "\nMesh " << results["cycles"].size() << ": " << elasticity->dof_handler().n_dofs()
        << " degrees of freedom";
    for (unsigned int body = 0; body < cells.size(); ++body)
      out << (body == 0 ? "; cells: " : ", ") << mesh->body_name(body) << " " << cells[body];
    out << std::endl;
  }



  template <int dim>
  void
  Simulation<dim>::build_contact()
  {
    // The solver refers to what is replaced here.
    newton.reset();
    mesh_clock.restart();
    const ContactMethod &method      = scene.contact.chosen();
    const Integration    integration = scene.contact.integration_of_degree(scene.degree);
    {
      TimerOutput::Scope scope(timer, "search");
      surfaces.clear();
      for (const ContactPair<dim> &pair : scene.pairs)
        surfaces.push_back(
          make_contact_surface(*elasticity, pair, scene.obstacle_of(pair), method, integration));
    }
    TimerOutput::Scope scope(timer, "contact");
    contact = make_gap_operator(*elasticity, surfaces, method);
    for (unsigned int i = 0; i < surfaces.size(); ++i)
      {
        const auto faces  = Utilities::MPI::sum(surfaces[i].faces, comm);
        const auto paired = Utilities::MPI::sum(surfaces[i].points.size(), comm);
        out << "  pair " << scene.pairs[i].name << ": " << scene.pairs[i].slave << " (" << faces
            << " faces) on " << scene.pairs[i].master << ", " << paired << " points on "
            << std::lround(100 * covered_share(surfaces[i], comm)) << " % of its area" << std::endl;
        if (paired == 0)
          throw SceneError(
            scene.pairs[i].master_place + ": no point of '" + scene.pairs[i].slave +
            "' has a partner there: the surfaces are farther apart than the Search distance, or do not face each other");
      }
    // What a former mesh knew of the pressure.
    LA::Vector start = contact->zero();
    if (pressure.size() == elasticity->dof_handler().n_dofs())
      contact->gather(pressure, start);
    pressure = start;
    mesh_clock.stop();
  }



  template <int dim>
  bool
  Simulation<dim>::solve(const double t, const double tolerance)
  {
    mesh_clock.start();
    elasticity->set_time(t);
    if (!newton)
      {
        {
          TimerOutput::Scope scope(timer, "assembly");
          elasticity->assemble();
        }
        NewtonSettings settings = scene.newton;
        settings.tolerance      = tolerance;
        newton                  = std::make_unique<Newton>(settings,
                                          scene.solver,
                                          scene.contact.chosen(),
                                          elasticity->stiffness(),
                                          elasticity->constraints(),
                                          *contact,
                                          elasticity->rigid_body_modes(),
                                          dim,
                                          timer);
      }
    LA::Vector f;
    {
      TimerOutput::Scope scope(timer, "assembly");
      f = elasticity->load();
    }
    elasticity->distribute(displacement);
    obstacle_motion.clear();
    for (const ContactPair<dim> &pair : scene.pairs)
      {
        obstacle_motion.emplace_back(dim, 0.);
        if (const Obstacle<dim> *obstacle = scene.obstacle_of(pair))
          for (unsigned int d = 0; d < dim; ++d)
            obstacle_motion.back()[d] = obstacle->motion(t)[d];
      }
    contact->set_obstacle_motion(obstacle_motion);

    report = newton->solve(f, displacement, pressure, out);
    elasticity->distribute(displacement);
    mesh_clock.stop();
    return report.converged;
  }



  template <int dim>
  void
  Simulation<dim>::refine_mesh()
  {
    TimerOutput::Scope scope(timer, "estimate");
    LA::Vector         nodal = elasticity->zero_vector();
    contact->scatter(pressure, nodal);
    elasticity->hanging_nodes().distribute(nodal);
    newton.reset();
    const double estimate =
      refine(scene.refinement, *mesh, *elasticity, displacement, {&displacement, &nodal});
    pressure = nodal;
    results["cycles"].push_back(
      {{"newton_iterations", report.steps.size()}, {"estimate", estimate}});
  }



  template <int dim>
  void
  Simulation<dim>::run_load_history()
  {
    for (unsigned int step = 1; step <= scene.load_steps.number; ++step)
      {
        const double t = scene.load_steps.end_time * step / scene.load_steps.number;
        if (scene.load_steps.number > 1)
          out << "  load step " << step << ", t = " << t << std::endl;
        if (!solve(t, scene.newton.tolerance))
          return;
        record_step(step, t);
      }
  }



  template <int dim>
  void
  Simulation<dim>::record_step(const unsigned int step, const double t)
  {
    TimerOutput::Scope  scope(timer, "output");
    const LA::Vector    gap = contact->gap(displacement);
    const Snapshot<dim> now{*elasticity,
                            scene.pairs,
                            surfaces,
                            *contact,
                            displacement,
                            gap,
                            pressure,
                            newton->active(),
                            obstacle_motion,
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
    results["converged"] = report.converged;
    results["reason"]    = report.reason;
    results["cells"]     = mesh->triangulation().n_global_active_cells();
    results["dofs"]      = elasticity->dof_handler().n_dofs();
    results["multiplier_dofs"] =
      scene.contact.chosen().has_multipliers() ? contact->weight.size() : 0;
    unsigned int faces = 0, candidates = 0;
    for (const ContactSurface<dim> &surface : surfaces)
      {
        faces += surface.faces;
        candidates += surface.points.size();
      }
    results["contact_faces"]      = Utilities::MPI::sum(faces, comm);
    results["contact_candidates"] = Utilities::MPI::sum(candidates, comm);

    results["seconds"]["total"] = Utilities::MPI::max(clock.wall_time(), comm);
    for (const auto &[name, time] : timer.get_summary_data(TimerOutput::total_wall_time))
      results["seconds"][name] = Utilities::MPI::max(time, comm);
    results["shares_of_ranks"] = shares_of_ranks(*elasticity, surfaces);
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
