// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/mpi.h>

#include <stdexcept>
#include <string>

namespace Signorini
{
  /// The directory in which a run leaves its files: locked while the run lasts, and cleared of what
  /// an earlier run left there, so that all files in it belong together.
  ///
  /// The lock is the file `run.lock` with "PID HOST". It is held by the operating system (flock),
  /// so that a run that was killed holds it no more: its file is taken over.
  class OutputDirectory
  {
  public:
    /// Creates the directory where there is none. Throws SceneError, before anything is changed, if
    /// that is impossible, another run holds it, or a file has one of the names that a run needs,
    /// but was not written by this program. Collective; the other ranks come back only when rank 0
    /// is ready.
    /// @param is_restart the files of the earlier run stay: it is to go on
    OutputDirectory(const std::string &path, MPI_Comm comm, bool is_restart = false);
    ~OutputDirectory();

    OutputDirectory(const OutputDirectory &) = delete;
    OutputDirectory &
    operator=(const OutputDirectory &) = delete;

    /// What a user wants to know of how it was found; may be empty. The same on all ranks.
    const std::string &
    note() const
    {
      return my_note;
    }

    /// Removes the files of load steps after that one. On rank 0.
    void
    remove_steps_after(unsigned int step) const;

  private:
    void
    release();

    const std::string path;
    int               lock = -1; ///< file descriptor, on rank 0
    std::string       my_note;
  };

  /// The first line of scene.prm, by which it is known for a file of this program.
  std::string
  mark_of_scene_file();

  /// A file that the disk does not take.
  class OutputError : public std::runtime_error
  {
  public:
    /// @param of_all all ranks throw it, else one
    OutputError(const std::string &path, const bool of_all)
      : std::runtime_error("cannot write " + path + "; is the disk full?")
      , of_all(of_all)
    {}

    const bool of_all;
  };

  /// Write the text beside the file, and put it in its place as a whole: readers never see half of
  /// it. Throws OutputError.
  void
  replace_file(const std::string &path, const std::string &text);
} // namespace Signorini
