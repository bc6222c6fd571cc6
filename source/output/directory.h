// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/mpi.h>

#include <stdexcept>
#include <string>

namespace Signorini
{
  /// The output directory of a run. It is locked while the run lasts, and files of an earlier run
  /// are removed first, so that all files in it belong together.
  ///
  /// The lock is the file `run.lock` with "PID HOST". The operating system holds it (flock), so
  /// that the lock of a run that was killed is free, and its file is taken over.
  class OutputDirectory
  {
  public:
    /// Create the directory if necessary, and lock it. Throws SceneError, before anything is
    /// changed, if that is impossible, if another run has locked it, or if a file that a run writes
    /// exists and was not written by this program. Collective; the other ranks return only when
    /// rank 0 is ready.
    /// @param path of the directory
    /// @param comm the ranks
    /// @param is_restart whether files of the earlier run are kept, because the run continues
    OutputDirectory(const std::string &path, MPI_Comm comm, bool is_restart = false);
    ~OutputDirectory();

    OutputDirectory(const OutputDirectory &) = delete;
    OutputDirectory &
    operator=(const OutputDirectory &) = delete;

    /// @return a message about the state in which the directory was found; may be empty. The same
    /// on all ranks.
    const std::string &
    note() const
    {
      return my_note;
    }

    /// Remove the files of later load steps. On rank 0 only.
    /// @param step the last load step whose files are kept
    void
    remove_steps_after(unsigned int step) const;

  private:
    /// Remove the lock file and release the lock.
    void
    release();

    const std::string path;
    /// File descriptor of the lock file on rank 0; -1 on other ranks.
    int         lock = -1;
    std::string my_note;
  };

  /// @return the first line of scene.prm, by which it is recognised as a file of this program.
  std::string
  mark_of_scene_file();

  /// A file could not be written.
  class OutputError : public std::runtime_error
  {
  public:
    /// @param path of the file
    /// @param of_all whether all ranks throw this error, or one only
    OutputError(const std::string &path, const bool of_all)
      : std::runtime_error("cannot write " + path + "; is the disk full?")
      , of_all(of_all)
    {}

    /// See the constructor.
    const bool of_all;
  };

  /// Write a file atomically: to a temporary file that is renamed, so that readers never see a part
  /// of it. Throws OutputError.
  /// @param path of the file
  /// @param text its contents
  void
  replace_file(const std::string &path, const std::string &text);
} // namespace Signorini
