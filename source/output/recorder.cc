// SPDX-License-Identifier: Apache-2.0
#include "output/recorder.h"

#include "accuracy/solution_errors.h"
#include "output/summary.h"
#include "scene/former_entries.h"
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
    one["fluids"]                  = fluid_results(now);
    one["cross_sections"]          = section_results(now, scene.output.cross_sections);
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
    write_scene(remark);
    begin();
    write();
  }



  // The mark is the first line, by which the file is recognised as one of this program.
  template <int dim>
  void
  Recorder<dim>::write_scene(const std::string &remark) const
  {
    if (Utilities::MPI::this_mpi_process(comm) != 0)
      return;
    std::string text = text_with_defaults(decisions);
    if (!remark.empty())
      text.insert(mark_of_scene_file().size(), "# " + remark + "\n");
    replace_file(path + "/scene.prm", text);
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
      // Checks of the earlier load steps are not repeated, but count for the verdict of the whole
      // run.
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
    const double before = clock.wall_time();
    // The copy keeps the former names out of the results in memory, which go into checkpoints.
    Json with_former = results;
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
    // A solution whose checks have failed counts as not converged for scripts that read this entry
    // alone.
    results["converged"] = report.converged && is_answer;
    results["reason"] = report.converged && !is_answer ? verdict.summary(outcome) : report.reason;
    add_costs();
    // Success needs an answer that agrees with the expected results.
    ExitCode code = is_interrupted ? interrupted : not_converged;
    if (report.converged)
      {
        print_summary(results, text);
        verdict.print(text);
        // The comparison is printed in any case, also for solutions that are no answer.
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
