// SPDX-License-Identifier: Apache-2.0
#include "driver/simulation.h"

#include "driver/scene_setup.h"
#include "output/directory.h"
#include "output/preflight.h"
#include "scene/skipped_items.h"
#include "solver/linear_reference.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A wall time for messages.
    std::string
    seconds(const double s)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(1) << s << " s";
      return text.str();
    }

    /// A report of a run that has no solution, for the given reason.
    NewtonReport
    unsolved(const std::string &why)
    {
      NewtonReport report;
      report.reason = why;
      return report;
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const Scene<dim> &scene,
                              const MPI_Comm    comm,
                              std::ostream     &stream,
                              const RunOrigin   origin)
    : scene(scene)
    , comm(comm)
    , out(stream, Utilities::MPI::this_mpi_process(comm) == 0)
    // Each rank measures its own times: there are no barriers, and no rank waits for one that has
    // failed.
    , timer(MPI_COMM_SELF, out, TimerOutput::never, TimerOutput::wall_times)
    , problem(this->scene, comm, out, timer, [this] { return watch(); })
    , refinement(this->scene, problem, comm, out, timer, clock)
    , origin(origin)
    // A target is for the sum of all errors.
    , path_control(scene.goals.has_targets() ?
                     std::min(scene.load_steps.path_error,
                              0.5 * *std::min_element(scene.goals.targets.begin(),
                                                      scene.goals.targets.end())) :
                     scene.load_steps.path_error)
  {
    out << "Signorini " << SIGNORINI_VERSION << ": " << scene.name;
    if (!scene.title.empty())
      out << " - " << scene.title;
    out << "\n"
        << scene.contact.chosen_name() << ", " << Utilities::MPI::n_mpi_processes(comm) << " ranks"
        << std::endl;
    if (!problem.decisions.reason.empty())
      out << "  chosen: " << problem.decisions.reason << std::endl;
    for (const SkippedItem &one : skipped_in(scene.skipped_items))
      out << "  not imported: " << one.kind << ": " << one.what << std::endl;
    for (const std::string &note : scene.notes)
      out << "  note: " << note << std::endl;
  }



  // Errors other than those of the output are recorded in the results before they are passed on.
  template <int dim>
  ExitCode
  Simulation<dim>::run()
  {
    const bool is_restart = origin == RunOrigin::checkpoint;
    if (is_restart)
      if (const auto code = exit_code_of_finished_run(scene, comm))
        {
          out << "The run in " << scene.output.directory << " is finished, with exit code " << *code
              << ": nothing was done." << std::endl;
          return *code;
        }
    const std::string remark =
      origin == RunOrigin::program ?
        "The scene of a program: its own obstacles, meshes and laws are not in this file." :
        "";
    recorder =
      std::make_unique<Recorder<dim>>(problem.decisions, clock, timer, comm, is_restart, remark);
    interruption = std::make_unique<Interruption>(clock, 60 * scene.output.time_limit, comm);
    if (!recorder->note().empty())
      out << "  note: " << recorder->note() << std::endl;
    try
      {
        return solve_scene();
      }
    catch (const OutputError &)
      {
        // No record can be written either.
        throw;
      }
    catch (const std::exception &error)
      {
        recorder->stop(error.what());
        throw;
      }
  }



  // The run: meshes until the targets are met (each with one solution at the end of the load
  // history, error estimate and refinement), then the whole load history on the last mesh, then the
  // estimate for its end. Failures and interruptions end in finish() with exit code and report.
  // Collective.
  template <int dim>
  ExitCode
  Simulation<dim>::solve_scene()
  {
    try
      {
        checkpoints = std::make_unique<RunCheckpoints<dim>>(
          origin, problem, refinement, *recorder, position, clock, timer, comm, out);
        set_up();
        for (; position.cycle < scene.maximum_cycles(); ++position.cycle)
          {
            problem.equilibrium->find_contact();
            report_set_up();
            pass_checkpoint();
            if (!solve_for_estimate())
              return finish(problem.report());
            if (!improve(refinement.control))
              break;
          }
        // The loop may end on a mesh on which contact was not searched for yet.
        if (!refinement.end_judged_on)
          {
            problem.equilibrium->find_contact();
            report_set_up();
          }
        // A restart between two load steps continues with the active set of the last one.
        if (position.step > 0)
          problem.equilibrium->configuration_solver.restore_active_set();
        pass_checkpoint();
        run_load_history();
        if (problem.report().converged && !scene.goals.quantities.empty())
          refinement.estimate_result(position.cycle, *recorder);
        if (problem.report().converged && scene.output.linear_reference)
          compare_with_linear_solve();
        return finish(problem.report());
      }
    catch (const SolverFailure &failure)
      {
        return finish(unsolved(failure.what()));
      }
    catch (const Interrupted &interruption)
      {
        is_interrupted = true;
        return finish(unsolved(interruption.what() +
                               std::string(checkpoints && checkpoints->has_progressed() ?
                                             "" :
                                             "; there is no checkpoint to restart from")));
      }
  }



  // For --check: everything up to the first solution, with the preflight report.
  template <int dim>
  void
  Simulation<dim>::preflight()
  {
    only_checks = true;
    set_up();
    problem.equilibrium->find_contact();
    report_set_up();
    out << "The scene is complete; nothing was solved." << std::endl;
  }



  // Mesh, elasticity and contact, from the scene or from a checkpoint.
  template <int dim>
  void
  Simulation<dim>::set_up()
  {
    const bool is_restored = checkpoints && checkpoints->has_former();
    {
      TimerOutput::Scope scope(timer, "mesh");
      // Decisions come before the mesh, whose refinement and degrees they contain.
      if (is_restored)
        checkpoints->restore_decisions();
      problem.make_mesh();
    }
    TimerOutput::Scope scope(timer, "setup");
    if (is_restored)
      checkpoints->restore_mesh();
    problem.set_up();
    if (is_restored)
      checkpoints->restore_state();

    if (problem.elasticity->has_unsupported_modes() && scene.output.linear_reference)
      throw SceneError(
        "Output/Linear reference = yes: without contact the bodies have unconstrained "
        "rigid-body modes; set it to no");
  }



  template <int dim>
  void
  // On the first mesh of a run that is not restarted: preflight checks of motions, probes and
  // expected results, before anything is solved.
  Simulation<dim>::report_set_up()
  {
    out << "\nMesh " << position.cycle << ": " << problem.elasticity->dof_handler().n_dofs()
        << " degrees of freedom, " << problem.mesh->triangulation().n_global_active_cells()
        << " cells" << std::endl;
    if (recorder)
      recorder->add_sizes(*problem.elasticity,
                          problem.contact->surfaces(),
                          problem.contact->gap_operator(),
                          problem.contact->skipped_items());
    if (position.cycle > 0 || (checkpoints && checkpoints->is_restored()))
      return;
    problem.equilibrium->configuration_solver.check_motions();
    check_requests();
    TimerOutput::Scope scope(timer, "preflight");
    const Json         report = Signorini::preflight(problem.decisions,
                                             *problem.elasticity,
                                             problem.contact->surfaces(),
                                             problem.contact->gap_operator(),
                                             clock.wall_time());
    std::ostringstream text;
    print_preflight(report, text, only_checks);
    out << text.str() << std::flush;
    if (recorder)
      recorder->add_preflight(report);
  }



  template <int dim>
  bool
  Simulation<dim>::is_finished() const
  {
    return position.time >= scene.load_steps.ends().back();
  }



  template <int dim>
  void
  Simulation<dim>::pass_checkpoint()
  {
    checkpoints->pass(is_finished());
    interruption->set_reserve(checkpoints->reserve());
  }



  template <int dim>
  void
  Simulation<dim>::compare_with_linear_solve()
  {
    const double          seconds = problem.mesh_seconds(), cycles = problem.multigrid_cycles();
    const LinearReference linear = [&]() {
      // The solver refers to the stiffness matrix.
      problem.equilibrium->configuration_solver.release();
      TimerOutput::Scope scope(timer, "linear reference");
      return solve_without_contact(*problem.elasticity, scene.solver, scene.newton.tolerance);
    }();
    recorder->add_linear_reference(linear, seconds, cycles);
  }



  /// True if external forces act, on bodies or on rigid obstacles: then displacement control is an
  /// alternative near limit points.
  namespace
  {
    template <int dim>
    bool
    is_driven_by_forces(const Scene<dim> &scene)
    {
      const auto has_free = [](const Obstacle<dim> &obstacle) {
        for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
          if (obstacle.body.is_free(i))
            return true;
        return false;
      };
      const auto has_pretension = [](const auto &pair) { return !pair.pretension.force.empty(); };
      const auto pairs          = scene.named_pairs();
      return !scene.loads.empty() || std::any_of(pairs.begin(), pairs.end(), has_pretension) ||
             std::any_of(scene.obstacles.begin(), scene.obstacles.end(), has_free);
    }
  } // namespace



  template <int dim>
  StepVisitor
  Simulation<dim>::watch()
  {
    const StepVisitor print = print_steps(out);
    return [this, print](const NewtonStep &step) {
      print(step);
      check_for_interruption();
    };
  }



  // End of the run: advice by the kind of failure, last checkpoint and failed iterate where there
  // is no solution, results, exit code. Collective.
  template <int dim>
  ExitCode
  Simulation<dim>::finish(NewtonReport end)
  {
    constexpr int digits = 6; // the next load step may fail at once
    if (!end.converged && end.tangent_is_indefinite)
      end.reason +=
        (problem.state.time > 0 ? "; the last converged load step ends at t = " +
                                    short_text(problem.state.time) + ", and beyond it" :
                                  std::string("; no load step converged, and")) +
        " the tangent was not positive definite: near a snap-through or buckling point no "
        "equilibrium exists under load control" +
        (is_driven_by_forces(scene) ? "; use displacement control" : "");
    else if (!end.converged && !is_interrupted && shortest_tried > 0)
      end.reason +=
        "; load steps down to " + short_text(shortest_tried) +
        " were tried from t = " + short_text(problem.state.time, digits) +
        (problem.state.time > 0 ?
           ": where contact slides off a corner or an edge, or a snap fit releases, no neighbouring "
           "equilibrium exists, and no load step is small enough; set Load steps/End time = " +
             short_text(problem.state.time, digits) + " to obtain the solution up to there" :
           "");
    if (!end.converged && !is_interrupted && position.cycle > 0)
      end.reason += "; the mesh before had a solution: set Accuracy/Refinement cycles = " +
                    std::to_string(position.cycle - 1) + " for its results and error bounds";
    recorder->add_sizes(*problem.elasticity,
                        problem.contact->surfaces(),
                        problem.contact->gap_operator(),
                        problem.contact->skipped_items());
    std::ostringstream text;
    if (!end.converged || scene.output.keep_checkpoint)
      checkpoints->write_last();
    if (!end.converged && !is_interrupted)
      if (const auto last = problem.equilibrium->failure(position.step + 1))
        recorder->add_failure(*last, end);
    const ExitCode code = recorder->finish(end, text, is_interrupted);
    // The checkpoints are removed only after the results say that the run is complete.
    if (end.converged && !scene.output.keep_checkpoint)
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
