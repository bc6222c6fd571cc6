// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/data_out_base.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The file that lists the files of all steps with their times, written anew after each step so
  /// that a run can be watched. Writes on rank 0 only.
  class PvdRecord
  {
  public:
    PvdRecord(const std::string &path, MPI_Comm comm);

    /// @param file name relative to the record; one that is there already is replaced (a step that
    /// was solved again on a finer mesh).
    void
    add(double time, const std::string &file);

    /// The entries of a run that goes on; nothing is written.
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

  /// Fast compression: the best one would take longer than the solution of small problems.
  dealii::DataOutBase::VtkFlags
  vtk_flags();
} // namespace Signorini
