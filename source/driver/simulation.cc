// SPDX-License-Identifier: Apache-2.0
#include "driver/simulation.h"

#include "driver/scene_setup.h"
#include "output/accuracy_results.h"
#include "output/directory.h"
#include "output/preflight.h"
#include "scene/skipped_items.h"
#include "solver/linear_reference.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

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
      if (const auto code = exit_code_of_finished_run(scene.output.directory))
        {
          out << "The run in " << scene.output.directory << " is finished, with exit code " << *code
              << ": nothing was done." << std::endl;
          return *code;
        }
    recorder = std::make_unique<Recorder<dim>>(problem.decisions, clock, timer, comm, is_restart);
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
        return finish(
          unsolved(interruption.what() +
                   std::string(checkpoints && checkpoints->has_progressed() ? "" :
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



  // Probes must be inside of bodies and expected results must name entries that results will have;
  // both are found by evaluating the outputs of the undeformed state.
  template <int dim>
  void
  Simulation<dim>::check_requests()
  {
    // On a mesh that is still to be refined, curved surfaces are not yet at their final positions.
    const bool is_final = scene.maximum_cycles() == 0;
    check_probes(*problem.elasticity,
                 problem.decisions.pairs,
                 scene.output.probes,
                 is_final ? probe_tolerance : 0.5);
    if (scene.expected.empty())
      return;
    const ContactState  nothing = open_contact(problem.contact->gap_operator());
    const LA::Vector    gap     = problem.contact->gap_operator().gap(problem.state.displacement);
    const Snapshot<dim> start{*problem.elasticity,
                              problem.decisions.pairs,
                              problem.contact->surfaces(),
                              problem.contact->gap_operator(),
                              problem.state.displacement,
                              gap,
                              nothing.pressure(),
                              nothing.status,
                              nothing,
                              scene.load_steps.ends().front(),
                              0};
    Json                step =
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
                                   "degrees",
                                   "multiplier_dofs",
                                   "contact_faces",
                                   "contact_candidates",
                                   "contact_bytes",
                                   "seconds",
                                   "partition",
                                   "peak_memory_mb",
                                   "preflight",
                                   "linear_reference",
                                   "contact_geometry",
                                   "deformation"};
    if (!is_final)
      whole.push_back("probes");
    check_paths(scene.expected, step, whole);
  }



  // The end of the load history in one step, which mostly converges; otherwise in steps from the
  // undeformed state. Collective.
  template <int dim>
  bool
  Simulation<dim>::solve_for_estimate()
  {
    // Only the end counts, and mostly it is found at once.
    const double end   = scene.load_steps.end_time;
    refinement.n_steps = 0;
    if (problem.solve(end, refinement.tolerance))
      {
        refinement.n_steps = problem.report().steps.size();
        return true;
      }
    if (problem.report().has_unconstrained_modes || scene.load_steps.shortest(end) == end)
      return false;
    out << "  no convergence in one load step (" << problem.report().reason
        << "): applying the load in steps" << std::endl;
    State nothing;
    nothing.displacement = problem.elasticity->zero_vector();
    nothing.contact      = SurfaceField(dim);
    problem.equilibrium->set_state(nothing, problem.equilibrium->uses_current_geometry());
    problem.equilibrium->configuration_solver.restore_active_set();
    Position start;
    start.longest = end / 2;
    return apply_load_history(refinement.tolerance, start, [&](auto) {
      refinement.n_steps += problem.report().steps.size();
      return true;
    });
  }



  // All load steps on the final mesh, each of which may refine it further if all steps are to meet
  // the targets.
  template <int dim>
  void
  Simulation<dim>::run_load_history()
  {
    // A single load step is the solution that was estimated, but other quantities than those of the
    // targets are read from it, too; of several load steps, some may have almost no forces, to
    // which the tolerance is relative. Hence the upper bound.
    constexpr double largest_tolerance = 1e-5;
    const bool       is_one            = scene.load_steps.ends().size() == 1;
    const double     final_tolerance =
      scene.goals.has_targets() && is_one ?
            std::max(std::min(refinement.tolerance, largest_tolerance), scene.newton.tolerance) :
            scene.newton.tolerance;
    apply_load_history(final_tolerance, position, [&](const unsigned int step) {
      // Meshes that were made for other load steps may be too coarse for the last one by a little.
      const bool is_judged =
        is_finished() && (!refinement.end_judged_on || *refinement.end_judged_on == position.cycle);
      if (scene.goals.judge_all_steps() && !is_judged && !improve_step())
        return false;
      record_step(step);
      pass_checkpoint();
      return true;
    });
  }



  template <int dim>
  bool
  Simulation<dim>::improve(ErrorControl &control)
  {
    if (!refinement.improve(control, position.cycle, *recorder))
      return false;
    // The state of the last checkpoint belongs to the old mesh.
    checkpoints->forget();
    return true;
  }



  // Meet the targets at one load step of the load history, by refinement of the mesh during the
  // run. Quantities below one hundredth of their final value are not resolved.
  template <int dim>
  bool
  Simulation<dim>::improve_step()
  {
    // A value that passes through zero has to be known only relative to its size at the end.
    constexpr double    small = 0.01;
    std::vector<double> least;
    for (const ErrorHistory &of_end : refinement.control.quantities())
      least.push_back(of_end.size() > 0 ? small * std::abs(of_end.last().value) : 0.);
    const bool         is_end = is_finished();
    ErrorControl       of_load(scene.goals, scene.refinement, least);
    ErrorControl      &its        = is_end ? refinement.control : of_load;
    const std::string  why_at_end = std::exchange(refinement.reason_targets_missed, {});
    const unsigned int most       = position.cycle + scene.maximum_cycles();
    for (;;)
      {
        refinement.n_steps = problem.report().steps.size();
        if (position.cycle == most)
          {
            refinement.step_accuracy =
              accuracy_results(scene.goals, its, refinement.judge(its, position.cycle));
            break;
          }
        if (!improve(its))
          break;
        ++position.cycle;
        problem.equilibrium->find_contact();
        report_set_up();
        if (!problem.solve(position.time, scene.newton.tolerance))
          return false;
      }
    if (is_end)
      return true;
    const std::string why              = refinement.missed_targets(of_load);
    refinement.step_accuracy["met"]    = why.empty();
    refinement.step_accuracy["reason"] = why;
    recorder->add_targets(of_load, why, position.time);
    refinement.reason_targets_missed = why_at_end;
    return true;
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



  // Adaptive load steps: between prescribed times (`ends`) a step that does not converge is halved,
  // down to the shortest admissible one, and steps grow again by the number of Newton steps. Ends
  // since each step advances the time by at least the shortest length, or the loop is left. Returns
  // false if a step failed or `visit` ends it.
  template <int dim>
  bool
  Simulation<dim>::apply_load_history(const double                                  tolerance,
                                      Position                                     &from,
                                      const std::function<bool(unsigned int step)> &visit)
  {
    const std::vector<double> ends    = scene.load_steps.ends();
    double                    start   = 0;
    auto &[cycle, t, number, longest] = from;
    for (const double end : ends)
      {
        const double shortest = scene.load_steps.shortest(end - start);
        start                 = end;
        while (t < end)
          {
            // A remainder that is longer than a step by rounding is taken at once.
            const double next = end - t <= 1.001 * longest ? end : t + longest;
            if (ends.size() > 1 || next < end)
              out << "  load step " << number + 1 << ", t = " << next << std::endl;
            if (problem.solve(next, tolerance))
              {
                longest =
                  scene.load_steps.next_length(next - t, problem.report().steps.size(), longest);
                t              = next;
                shortest_tried = 0;
                if (!visit(++number))
                  return false;
              }
            else
              {
                longest = (next - t) / 2;
                if (longest < 0.999 * shortest || problem.report().has_unconstrained_modes)
                  return false;
                out << "  no convergence (" << problem.report().reason
                    << (problem.report().tangent_is_indefinite ?
                          "; the tangent was not positive definite" :
                          "")
                    << "): halving the load step" << std::endl;
                shortest_tried = longest;
              }
          }
      }
    return true;
  }



  // Output of a load step; collective.
  template <int dim>
  void
  Simulation<dim>::record_step(const unsigned int step)
  {
    TimerOutput::Scope scope(timer, "output");
    recorder->add_contact_geometry(problem.equilibrium->neglected(),
                                   problem.equilibrium->uses_current_geometry());
    recorder->add_deformation(problem.neglected_work, problem.elasticity->is_finite_strain());
    const Snapshot<dim> now = problem.equilibrium->snapshot(step);
    if (after_step)
      after_step(now);
    recorder->add_step(now,
                       problem.report(),
                       problem.multigrid_cycles(),
                       std::exchange(refinement.step_accuracy, {}));
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
      return !scene.loads.empty() ||
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
        " were tried from t = " + short_text(problem.state.time) +
        ": where contact slides off a corner or an edge, or a snap fit releases, no neighbouring "
        "equilibrium exists, and no load step is small enough" +
        (problem.state.time > 0 ? "; set Load steps/End time = " + short_text(problem.state.time) +
                                    " to obtain the solution up to there" :
                                  "");
    recorder->add_sizes(*problem.elasticity,
                        problem.contact->surfaces(),
                        problem.contact->gap_operator(),
                        problem.contact->skipped_items());
    std::ostringstream text;
    if (!end.converged)
      checkpoints->write_last();
    if (!end.converged && !is_interrupted)
      if (const auto last = problem.equilibrium->failure(position.step + 1))
        recorder->add_failure(*last, end);
    const ExitCode code = recorder->finish(end, text, is_interrupted);
    // The checkpoints are removed only after the results say that the run is complete.
    if (end.converged)
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
