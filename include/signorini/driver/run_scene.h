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
  /// What is to be done with a scene file.
  struct SceneTask
  {
    std::string              scene;     ///< the file
    std::vector<std::string> overrides; ///< "Section/Key=value", as after --set
    bool                     only_check = false;
    std::string restart = ""; ///< instead of the scene: output directory of a run that goes on
  };

  /// A scene that was read and checked as far as this goes without a distributed mesh: MPI need not
  /// be there yet.
  class PreparedScene
  {
  public:
    virtual ~PreparedScene() = default;

    /// Throws SceneError.
    static std::unique_ptr<PreparedScene>
    read(const SceneTask &task);

    /// Solve it, or report what would be solved, by words on `out` of the first rank. Collective;
    /// throws SceneError on all ranks alike.
    virtual ExitCode
    run(MPI_Comm comm, std::ostream &out) const = 0;
  };

  /// All of it, and any number of times in a process: nothing is left behind but files. Errors go
  /// to `err` of the first rank, as by exit_code_of().
  int
  run_scene(const SceneTask &task, MPI_Comm comm, std::ostream &out, std::ostream &err);

  /// What `work` returns. A SceneError becomes bad_scene and a message, on `err` if `speaks`; all
  /// else that is thrown an internal_error, told by each rank, and the end of all ranks if there
  /// are others, which may wait for this one forever.
  int
  exit_code_of(const std::function<int()> &work, bool speaks, std::ostream &err);
} // namespace Signorini
