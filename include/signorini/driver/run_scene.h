// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/base/exit_code.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// A task for the program: a scene file, or the continuation of a run.
  struct SceneTask
  {
    std::string              scene;     ///< the file
    std::vector<std::string> overrides; ///< "Section/Key=value", as after --set
    /// Check the scene and report what would be solved, without solving.
    bool        only_check = false;
    std::string restart    = ""; ///< instead of the scene: output directory of a run that goes on
  };

  /// A scene that was read and checked as far as this is possible without a distributed mesh. MPI
  /// need not be initialised.
  class PreparedScene
  {
  public:
    virtual ~PreparedScene() = default;

    /// Read and check the scene of a task. Throws SceneError.
    static std::unique_ptr<PreparedScene>
    read(const SceneTask &task);

    /// Solve the scene, or report what would be solved. Throws SceneError on all ranks alike.
    /// Collective.
    /// @param comm MPI is initialised
    /// @param out stream for messages of the first rank
    /// @return the exit code
    virtual ExitCode
    run(MPI_Comm comm, std::ostream &out) const = 0;
  };

  /// Read and run a task; may be called repeatedly in one process, and leaves nothing but files.
  /// Errors are written to `err` of the first rank, as by exit_code_of().
  /// @return the exit code
  int
  run_scene(const SceneTask &task, MPI_Comm comm, std::ostream &out, std::ostream &err);

  /// Perform `work` and convert exceptions to exit codes. SceneError: bad_scene, with a message to
  /// `err` if `speaks`. Any other exception: internal_error with a message of each rank, and the
  /// abort of all ranks if there are several, since the others may wait for this one.
  /// @return the result of `work`, or the code of the exception
  int
  exit_code_of(const std::function<int()> &work, bool speaks, std::ostream &err);
} // namespace Signorini
