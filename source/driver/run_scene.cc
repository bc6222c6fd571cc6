// SPDX-License-Identifier: Apache-2.0
#include "checkpoint/origin.h"
#include "driver/scene_setup.h"
#include "driver/simulation.h"
#include "output/directory.h"
#include <signorini/base/text.h>
#include <signorini/driver/run_scene.h>
#include <signorini/parameters/raw.h>

#include <filesystem>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A scene of one dimension that was read and checked.
    template <int dim>
    class Prepared : public PreparedScene
    {
    public:
      Prepared(RawSection &raw, const SceneTask &task, const std::string &name)
        : scene(
            read_scene<dim>(raw, name, std::filesystem::path(task.scene).parent_path().string()))
        , only_check(task.only_check)
        , origin(task.restart.empty() ? RunOrigin::scene_file : RunOrigin::checkpoint)
      {
        // What was solved cannot change any more.
        const auto end = task.restart.empty() ? std::nullopt : end_of_finished_run(task.restart);
        for (const std::string &assignment : task.overrides)
          if (end && is_of_further_steps(assignment) && scene.load_steps.ends().back() <= *end)
            throw SceneError("--restart " + task.restart + ": --set " + assignment +
                             " is for load steps after t = " + short_text(*end) +
                             ", where the run has ended; set a later Load steps/End time, or later "
                             "Load steps/Times where these are set");
      }

      ExitCode
      run(const MPI_Comm comm, std::ostream &out) const override
      {
        Simulation<dim> simulation(scene, comm, out, origin);
        if (!only_check)
          return simulation.run();
        simulation.preflight();
        return solved;
      }

    private:
      const Scene<dim> scene;
      const bool       only_check;
      const RunOrigin  origin;
    };

    /// The input of a task, without its overrides, and the name of the scene: from a file, or for a
    /// restart from the origin stored in the output directory, whose changes are restricted.
    std::pair<RawSection, std::string>
    read_task(const SceneTask &task)
    {
      if (task.restart.empty())
        return {read_raw(task.scene), std::filesystem::path(task.scene).stem()};
      const Origin       origin = read_origin(task.restart);
      std::istringstream text(origin.scene);
      RawSection         raw         = read_raw(text, task.restart + "/restart.scene");
      const bool         is_finished = end_of_finished_run(task.restart).has_value();
      for (const std::string &assignment : task.overrides)
        check_change(assignment, is_finished);
      override_value(raw, "Output/Directory=" + task.restart);
      return {raw, origin.name};
    }
  } // namespace



  std::unique_ptr<PreparedScene>
  PreparedScene::read(const SceneTask &task)
  {
    auto [raw, name] = read_task(task);
    for (const std::string &assignment : task.overrides)
      override_value(raw, assignment);

    const RawSection::Value *dimension = raw.find_value("Dimension");
    if (!dimension)
      throw SceneError(task.scene +
                       ": 'Dimension' is not set; write set Dimension = 2 or 3 at the top");
    if (dimension->text == "2")
      return std::make_unique<Prepared<2>>(raw, task, name);
    if (dimension->text == "3")
      return std::make_unique<Prepared<3>>(raw, task, name);
    throw SceneError(dimension->where + ": Dimension = " + dimension->text + ": must be 2 or 3");
  }



  int
  run_scene(const SceneTask &task, const MPI_Comm comm, std::ostream &out, std::ostream &err)
  {
    return exit_code_of([&] { return PreparedScene::read(task)->run(comm, out); },
                        Utilities::MPI::this_mpi_process(comm) == 0,
                        err);
  }



  // SceneError: all ranks read the same input and throw together, so that no rank waits for
  // another. Any other exception may occur on one rank only: the ranks are then aborted, since the
  // others may wait forever.
  int
  exit_code_of(const std::function<int()> &work, const bool speaks, std::ostream &err)
  {
    try
      {
        return work();
      }
    catch (const SceneError &error)
      {
        // All ranks read the same input and end here together.
        if (speaks)
          err << "error: " << error.what() << std::endl;
        return bad_scene;
      }
    catch (const OutputError &error)
      {
        if (speaks || !error.of_all)
          err << "error: " << error.what() << std::endl;
        if (!error.of_all && Utilities::MPI::job_supports_mpi() &&
            Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
          MPI_Abort(MPI_COMM_WORLD, internal_error);
        return internal_error;
      }
    catch (const std::exception &error)
      {
        const bool has_mpi = Utilities::MPI::job_supports_mpi();
        err << "internal error on rank "
            << (has_mpi ? Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) : 0) << ": "
            << error.what() << std::endl;
        if (has_mpi && Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
          MPI_Abort(MPI_COMM_WORLD, internal_error);
        return internal_error;
      }
  }
} // namespace Signorini
