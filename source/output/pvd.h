// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/data_out_base.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The file that lists the files of all load steps with their times. It is written anew after
  /// each step, so that a run can be watched. Rank 0 writes.
  class PvdRecord
  {
  public:
    /// @param path of the file
    /// @param comm the ranks
    PvdRecord(const std::string &path, MPI_Comm comm);

    /// Add a load step. Throws OutputError.
    /// @param time of the load step
    /// @param file name relative to the record; an entry with this name is replaced (a step that
    /// was solved again on a finer mesh)
    void
    add(double time, const std::string &file);

    /// Set the entries of a run that is continued; nothing is written.
    /// @param entries times and file names
    void
    restore(const std::vector<std::pair<double, std::string>> &entries)
    {
      steps = entries;
    }

  private:
    const std::string                           path;
    const bool                                  writes;
    std::vector<std::pair<double, std::string>> steps;
  };

  /// @return flags for fast compression: the best one would take longer than the solution of small
  /// problems.
  dealii::DataOutBase::VtkFlags
  vtk_flags();
} // namespace Signorini
