// SPDX-License-Identifier: Apache-2.0
// Load steps that are added to a finished run.
#include "checkpoint/origin.h"
#include "driver/run_checkpoints.h"
#include "solid/fluid_spread.h"
#include "solid/reactions.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <fstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The results in an output directory; an empty object if there are none.
    Json
    results_in(const std::string &directory)
    {
      std::ifstream file(directory + "/results.json");
      const Json    results = Json::parse(file, nullptr, false);
      return results.is_object() && results.contains("load_steps") ? results : Json::object();
    }

    /// The time of the last load step; zero if there is none.
    double
    last_time(const Json &results)
    {
      const Json &steps = results.at("load_steps");
      return steps.empty() ? 0. : steps.back().at("time").get<double>();
    }
  } // namespace



  std::optional<double>
  end_of_finished_run(const std::string &directory)
  {
    const Json results = results_in(directory);
    if (results.empty())
      return {};
    if (results.value("complete", false))
      return last_time(results);
    const Origin origin = read_origin(directory);
    return origin.continues != 0 && last_time(results) <= origin.begin ?
             std::optional<double>(origin.begin) :
             std::nullopt;
  }



  template <int dim>
  std::optional<ExitCode>
  exit_code_of_finished_run(const Scene<dim> &scene, const MPI_Comm comm)
  {
    const std::string &directory = scene.output.directory;
    const Json         results   = results_in(directory);
    if (!results.value("complete", false))
      return {};
    Checkpoints  checkpoints(directory, comm);
    const double end = scene.load_steps.ends().back();
    if (end > last_time(results))
      {
        if (checkpoints.empty())
          throw SceneError("--restart " + directory + ": Load steps/End time = " + short_text(end) +
                           " is beyond the end of the finished run, which has left no checkpoint; "
                           "solve the scene with Output/Keep checkpoint = yes");
        return {};
      }
    if (!scene.output.keep_checkpoint)
      checkpoints.remove();
    return static_cast<ExitCode>(results.at("exit_code").get<int>());
  }



  // The scene with the further load steps takes the place of the former one, whose checkpoint stays
  // valid for it. Meshes that errors have led to are not refined again.
  template <int dim>
  void
  RunCheckpoints<dim>::add_load_steps(const double end)
  {
    out << "  further load steps after t = " << end
        << ": up to there, loads and supports are those that were solved" << std::endl;
    adds_load_steps = true;
    position.cycle  = std::max(position.cycle, problem.decisions.scene.maximum_cycles());
    if (Utilities::MPI::this_mpi_process(comm) == 0)
      {
        Origin origin =
          origin_of(problem.decisions.scene.name, text_with_defaults(problem.decisions));
        origin.continues = former->head.at("origin");
        origin.begin     = end;
        write_origin(recorder.directory(), origin);
        scene_checksum = checksum_of_origin(recorder.directory());
      }
    scene_checksum = Utilities::MPI::broadcast(comm, scene_checksum);
    recorder.write_scene("");
  }



  // At the end of the finished run, supports must prescribe the displacement that was solved, and
  // loads must have the resultant of then. Earlier times are not checked. Collective.
  template <int dim>
  void
  RunCheckpoints<dim>::check_past() const
  {
    constexpr double  rounding   = 1e-6;
    const double      time       = problem.state.time;
    Elasticity<dim>  &elasticity = *problem.elasticity;
    const LA::Vector &then       = problem.state.displacement;
    LA::Vector        now        = then;
    const std::string beginning  = "--restart " + recorder.directory() +
                                  ": at t = " + short_text(time) +
                                  ", where the further load steps begin, ";
    elasticity.set_time(time);
    elasticity.distribute(now);
    now -= then;
    if (now.linfty_norm() >
        rounding * std::max(then.linfty_norm(), rounding * problem.mesh->size()))
      throw SceneError(
        beginning + "Supports prescribe other displacements than those that were solved; let them "
                    "continue from there, or set a Start time of new ones");
    // Where fluids are is found in the next load step.
    if (has_fluids(elasticity.loads()))
      return;
    const Json          &step = recorder.load_steps().back();
    const Tensor<1, dim> load = reactions(elasticity, then, elasticity.zero_vector()).load.force;
    Tensor<1, dim>       before;
    for (unsigned int d = 0; d < dim; ++d)
      before[d] = step.at("total_load").at(d);
    const double scale =
      std::max({step.at("largest_force").get<double>(), load.norm(), before.norm()});
    if ((load - before).norm() > rounding * scale)
      throw SceneError(beginning +
                       "Loads have another resultant than those that were solved; let them "
                       "continue from there");
  }



#define INSTANTIATE(dim)                                                                           \
  template std::optional<ExitCode> exit_code_of_finished_run(const Scene<dim> &, MPI_Comm);        \
  template void                    RunCheckpoints<dim>::add_load_steps(double);                    \
  template void                    RunCheckpoints<dim>::check_past() const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
