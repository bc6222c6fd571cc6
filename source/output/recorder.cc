// SPDX-License-Identifier: Apache-2.0
#include "output/recorder.h"

#include "accuracy/solution_errors.h"
#include "output/summary.h"
#include "scene/former_entries.h"
#include "verdict/checks.h"
#include <signorini/parameters/section.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr char unfinished[] = "unfinished: the run is in progress, or was terminated";

    /// @return the output directory of a scene, output/NAME by default.
    template <int dim>
    std::string
    directory_of(const Scene<dim> &scene)
    {
      return scene.output.directory.empty() ? "output/" + scene.name : scene.output.directory;
    }

  } // namespace



  template <int dim>
  std::string
  text_with_defaults(const Decisions<dim> &decisions)
  {
    std::ostringstream text;
    text << mark_of_scene_file();
    Section section(text, false, 0, &decisions.scene.given);
    decisions.explicit_scene().declare(section);
    return text.str();
  }



  // Errors are reported for those fields only that are known.
  template <int dim>
  Json
  results_at(const Scene<dim>              &scene,
             const Snapshot<dim>           &now,
             const std::vector<Probe<dim>> &probes)
  {
    Json one = {{"pairs", pair_results(now)}};
    one.update(force_results(now, scene.newton.tolerance));
    one["probes"]                  = probe_results(now, probes);
    const SolutionErrors deviation = errors(now, scene.known);
    if (!scene.known.displacement.empty())
      {
        one["errors"]["displacement"] = deviation.displacement;
        one["errors"]["energy"]       = deviation.energy;
      }
    if (!scene.known.volumetric_stress.empty())
      one["errors"]["volumetric_stress"] = deviation.volumetric_stress;
    if (!scene.known.pressure.empty())
      {
        one["errors"]["pressure"]           = deviation.pressure;
        one["errors"]["recovered_pressure"] = deviation.recovered_pressure;
      }
    return one;
  }



  template <int dim>
  Recorder<dim>::Recorder(const Decisions<dim> &decisions,
                          const Timer          &clock,
                          const TimerOutput    &timer,
                          const MPI_Comm        comm,
                          const bool            is_restart,
                          const std::string    &remark)
    : decisions(decisions)
    , scene(decisions.scene)
    , clock(clock)
    , timer(timer)
    , comm(comm)
    , path(directory_of(scene))
    , folder(path, comm, is_restart)
    , writer(scene.output, path, comm)
    , seconds_before(Json::object())
  {
    if (is_restart)
      return;
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      {
        // The mark is the first line, by which the file is recognised as one of this program.
        std::string text = text_with_defaults(decisions);
        if (!remark.empty())
          text.insert(mark_of_scene_file().size(), "# " + remark + "\n");
        replace_file(path + "/scene.prm", text);
      }
    begin();
    write();
  }



  // The entries that do not change during the run.
  template <int dim>
  void
  Recorder<dim>::begin()
  {
    results               = {{"program", "Signorini"},
                             {"version", SIGNORINI_VERSION},
                             {"scene", scene.name},
                             {"title", scene.title},
                             {"libraries", library_versions()},
                             {"ranks", Utilities::MPI::n_mpi_processes(comm)},
                             {"dimension", dim},
                             {"method", scene.contact.chosen_name()},
                             {"complete", false},
                             {"converged", false},
                             {"reason", unfinished},
                             {"output_directory", path}};
    results["cycles"]     = Json::array();
    results["load_steps"] = Json::array();
  }



  // The results of the earlier process are continued; what concerns the process itself is replaced.
  // Times of both are added.
  template <int dim>
  void
  Recorder<dim>::restore(const Json &former)
  {
    if (former.empty())
      begin();
    else
      results = former;
    results["version"]          = SIGNORINI_VERSION;
    results["libraries"]        = library_versions();
    results["ranks"]            = Utilities::MPI::n_mpi_processes(comm);
    results["complete"]         = false;
    results["converged"]        = false;
    results["reason"]           = unfinished;
    results["output_directory"] = path;

    // The verdict, the list of output times and the largest force continue those of the earlier
    // process.
    seconds_before = results.value("seconds", Json::object());
    if (results.contains("verdict"))
      verdict = Verdict::from(results["verdict"]);
    std::vector<std::pair<double, unsigned int>> times;
    for (const Json &step : results["load_steps"])
      {
        times.emplace_back(step.at("time"), step.at("step"));
        if (const Json &force = step.at("largest_force"); force.is_number())
          largest_force = std::max(largest_force, force.get<double>());
      }
    writer.restore(times);
    // Rank 0 removes the files of steps after the checkpoint, since these steps are computed again.
    const unsigned int last = times.empty() ? 0 : times.back().second;
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      folder.remove_steps_after(last);
    results["restarts"].push_back({{"after_step", last},
                                   {"cycle", results["cycles"].size()},
                                   {"ranks", results["ranks"]},
                                   {"seconds", seconds_before.value("total", 0.)}});
    write();
  }



  template <int dim>
  const Json &
  Recorder<dim>::save()
  {
    add_costs();
    return results;
  }



  template <int dim>
  void
  Recorder<dim>::add_preflight(const Json &report)
  {
    results["preflight"] = report;
  }



  template <int dim>
  void
  Recorder<dim>::add_contact_geometry(const std::optional<double> change, const bool updated)
  {
    Json &geometry      = results["contact_geometry"];
    geometry["updated"] = updated;
    if (change)
      geometry["change_of_pressure"] = *change;
  }



  template <int dim>
  void
  Recorder<dim>::add_deformation(const std::optional<double> neglected, const bool finite)
  {
    Json &deformation     = results["deformation"];
    deformation["finite"] = finite;
    if (neglected)
      deformation["neglected_work"] = *neglected;
  }



  template <int dim>
  void
  Recorder<dim>::add_cycle(const unsigned int newton_iterations,
                           const unsigned int multigrid_cycles,
                           const Json        &accuracy)
  {
    results["cycles"].push_back({{"newton_iterations", newton_iterations},
                                 {"multigrid_cycles", multigrid_cycles},
                                 {"dofs", results["dofs"]},
                                 {"seconds", clock.wall_time()},
                                 {"accuracy", accuracy}});
  }



  // The errors of the last load step are reported at the top level as well.
  template <int dim>
  void
  Recorder<dim>::add_accuracy(const Json         &accuracy,
                              const ErrorControl &control,
                              const std::string  &why)
  {
    const double end    = scene.load_steps.ends().back();
    results["accuracy"] = accuracy;
    if (scene.goals.has_targets())
      {
        results["accuracy"]["met"]    = why.empty();
        results["accuracy"]["reason"] = why;
        add_targets(control, why, end);
      }
    results["load_steps"].back()["accuracy"] = results["accuracy"];
    const auto all                           = results["load_steps"].size();
    const auto open                          = std::count_if(results["load_steps"].begin(),
                                    results["load_steps"].end(),
                                    [](const Json &step) { return step["accuracy"].is_null(); });
    if (scene.goals.has_targets() && all > 1)
      verdict.add(check_judged_steps(open, all), end);
    results["verdict"] = verdict.json();
  }



  // The check of the targets becomes a part of the verdict.
  template <int dim>
  void
  Recorder<dim>::add_targets(const ErrorControl &control, const std::string &why, const double time)
  {
    verdict.add(check_targets(scene.goals, control, why), time);
    results["verdict"] = verdict.json();
  }



  // Counts of iterations between augmentations are reported for the augmented Lagrangian.
  template <int dim>
  Json
  Recorder<dim>::newton_results(const NewtonReport &report) const
  {
    Json krylov = Json::array(), augmentations = Json::array();
    // Linear iterations of each Newton step, and the numbers of Newton steps between augmentations.
    unsigned int before = 0;
    for (const NewtonStep &row : report.steps)
      {
        if (row.krylov_iterations > 0)
          krylov.push_back(row.krylov_iterations);
        if (row.augmented)
          {
            augmentations.push_back(krylov.size() - before);
            before = krylov.size();
          }
      }
    Json result = {{"newton_iterations", krylov.size()},
                   {"active_points", report.steps.back().active},
                   {"residual", report.steps.back().residual},
                   {"tangent_positive_definite", !report.tangent_is_indefinite},
                   {"snap_through_ratio", report.speed_ratio},
                   {"krylov_iterations", krylov},
                   {"newton_iterations_before_augmentations", augmentations}};
    if (!report.undetermined_modes.empty())
      result["stabilised_modes"] = {{"names", report.undetermined_modes},
                                    {"largest_force", report.stabilisation_force}};
    return result;
  }



  // The verdict needs the largest force of all steps so far, which is updated first.
  template <int dim>
  void
  Recorder<dim>::add_step(const Snapshot<dim> &now,
                          const NewtonReport  &report,
                          const unsigned int   multigrid_cycles,
                          const Json          &accuracy)
  {
    Json one = {{"step", now.step}, {"time", now.time}};
    one.update(newton_results(report));
    one["multigrid_cycles"] = multigrid_cycles;
    one.update(results_at(scene, now, scene.output.probes));
    largest_force = std::max(largest_force, one["largest_force"].get<double>());
    // The checks see the results of this step and the largest force so far.
    verdict.add(check_solution(decisions, now, one, largest_force), now.time);
    results["verdict"] = verdict.json();
    if (!scene.goals.quantities.empty())
      one["accuracy"] = accuracy; // null: not judged
    results["load_steps"].push_back(one);
    writer.write(now, scene.known.pressure);

    // The file grows with each step: it is written only if that takes less than a twentieth of the
    // time since the last writing.
    add_costs();
    if (clock.wall_time() - written_at >= 20 * writing_takes)
      write();
  }



  // The status 2 marks contact points that alternate; they are counted by pair.
  template <int dim>
  void
  Recorder<dim>::add_failure(const Snapshot<dim> &now, const NewtonReport &report)
  {
    Json one = {{"step", now.step}, {"time", now.time}, {"reason", report.reason}};
    if (!report.steps.empty())
      {
        one["residual"]     = report.steps.back().residual;
        one["gap_residual"] = report.steps.back().gap_residual;
      }
    const auto &mesh = now.elasticity.mesh();
    if (report.worst_body < mesh.n_bodies())
      one["body"] = mesh.body_name(report.worst_body);
    std::vector<unsigned int> chattering(now.pairs.size(), 0);
    auto                      pair = now.contact.origin.pair.begin();
    for (const double status : now.active)
      chattering[*pair++] += status > 1.5;
    Utilities::MPI::sum(chattering, comm, chattering);
    for (unsigned int i = 0; i < now.pairs.size(); ++i)
      one["pairs"].push_back({{"pair", now.pairs[i].name}, {"chattering_points", chattering[i]}});
    results["failed_step"] = one;
    writer.write_failure(now);
  }



  template <int dim>
  void
  Recorder<dim>::add_linear_reference(const LinearReference &linear,
                                      const double           seconds,
                                      const double           cycles)
  {
    results["linear_reference"] = {{"seconds",
                                    {{"assembly", linear.seconds_assembly},
                                     {"preconditioner", linear.seconds_preconditioner},
                                     {"krylov", linear.seconds_krylov}}},
                                   {"krylov_iterations", linear.iterations},
                                   {"near_null_space",
                                    word_of(near_null_spaces(), linear.near_null_space)},
                                   {"contact_seconds", seconds},
                                   {"contact_multigrid_cycles", cycles},
                                   {"time_ratio", seconds / linear.seconds()},
                                   {"cycle_ratio", cycles / linear.iterations}};
  }



  // Sums over all ranks.
  template <int dim>
  void
  Recorder<dim>::add_sizes(const Elasticity<dim>                  &elasticity,
                           const std::vector<ContactSurface<dim>> &surfaces,
                           const GapOperator                      &contact,
                           const std::vector<std::string>         &skipped_items)
  {
    results["cells"] = elasticity.mesh().triangulation().n_global_active_cells();
    results["dofs"]  = elasticity.dof_handler().n_dofs();
    for (unsigned int body = 0; body < scene.bodies.size(); ++body)
      results["degrees"][scene.bodies[body].name] = decisions.degrees[body];
    results["multiplier_dofs"] =
      scene.contact.chosen().has_multipliers() ? contact.n_components() * contact.weight.size() : 0;
    results["skipped"] = skipped_items;
    // Slave faces and candidate points of all pairs on this rank, before the sum.
    unsigned int faces = 0, candidates = 0;
    for (const ContactSurface<dim> &surface : surfaces)
      {
        faces += surface.faces;
        candidates += surface.points.size();
      }
    results["contact_faces"]      = Utilities::MPI::sum(faces, comm);
    results["contact_candidates"] = Utilities::MPI::sum(candidates, comm);
    results["contact_bytes"]      = Utilities::MPI::sum(contact.memory_consumption(), comm);
    results["partition"]          = shares_of_ranks(elasticity, surfaces);
  }



  // Seconds are the largest of all ranks, plus those of the processes before a restart. Collective.
  template <int dim>
  void
  Recorder<dim>::add_costs()
  {
    const auto add = [&](const std::string &name, const double here) {
      results["seconds"][name] = seconds_before.value(name, 0.) + Utilities::MPI::max(here, comm);
    };
    add("total", clock.wall_time());
    for (const auto &[name, time] : timer.get_summary_data(TimerOutput::total_wall_time))
      add(name, time);
    results["peak_memory_mb"] = peak_memory(comm);
  }



  // Rank 0 replaces results.json atomically. The former names of renamed entries are written as
  // well, for scripts that read them.
  template <int dim>
  void
  Recorder<dim>::write()
  {
    if (Utilities::MPI::this_mpi_process(comm) != 0)
      return;
    const double before      = clock.wall_time();
    Json         with_former = results;
    add_former_entries(with_former);
    replace_file(path + "/results.json", with_former.dump(2) + "\n");
    written_at    = clock.wall_time();
    writing_takes = written_at - before;
  }



  // The run has an answer if Newton's method has converged and no check has failed (with
  // Output/Strict: has warned).
  template <int dim>
  ExitCode
  Recorder<dim>::finish(const NewtonReport &report, std::ostream &text, const bool is_interrupted)
  {
    const Outcome outcome = verdict.outcome();
    const bool    is_answer =
      outcome == Outcome::passed || (outcome == Outcome::warned && !scene.output.strict);
    results["converged"] = report.converged && is_answer;
    results["reason"] = report.converged && !is_answer ? verdict.summary(outcome) : report.reason;
    add_costs();
    // Success needs an answer that agrees with the expected results.
    ExitCode code = is_interrupted ? interrupted : not_converged;
    if (report.converged)
      {
        print_summary(results, text);
        verdict.print(text);
        const bool as_expected = compare(scene.expected, results, text);
        code                   = !is_answer ? not_converged : as_expected ? solved : missed;
      }
    if (!report.converged || !is_answer)
      text << "\n"
           << (is_interrupted   ? "Ended: " :
               report.converged ? "No answer: " :
                                  "Not solved: ")
           << results["reason"].get<std::string>() << "\n";
    results["complete"]  = report.converged;
    results["exit_code"] = code;
    write();
    return code;
  }



  template <int dim>
  void
  Recorder<dim>::stop(const std::string &why)
  {
    if (results.empty())
      return; // no results yet: the file of an earlier process is kept
    results["converged"] = false;
    results["reason"]    = why;
    try
      {
        write();
      }
    catch (const std::runtime_error &)
      {
        // The error of the disk may be the reason why the run ends; then that error is reported,
        // not this one.
      }
  }



  template std::string
  text_with_defaults(const Decisions<2> &);
  template std::string
  text_with_defaults(const Decisions<3> &);
  template Json
  results_at(const Scene<2> &, const Snapshot<2> &, const std::vector<Probe<2>> &);
  template Json
  results_at(const Scene<3> &, const Snapshot<3> &, const std::vector<Probe<3>> &);
  template class Recorder<2>;
  template class Recorder<3>;
} // namespace Signorini
