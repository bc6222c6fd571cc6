// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include "output/pvd.h"
#include <signorini/scene/output_settings.h>

#include <string>

namespace Signorini
{
  /// Writes the files for visualisation: in `directory` solution.pvd and contact.pvd with one entry
  /// for each step (unless settings.vtu is false), and the profiles of each step.
  template <int dim>
  class Writer
  {
  public:
    /// @param settings of the output
    /// @param directory which exists, see OutputDirectory
    /// @param comm the ranks
    Writer(const OutputSettings<dim> &settings, const std::string &directory, MPI_Comm comm);

    /// Write the files of a load step. Throws OutputError. Collective.
    /// @param snapshot the solution
    /// @param reference_pressure formula that is evaluated beside the pressure in profiles; may be
    /// empty
    void
    write(const Snapshot<dim> &snapshot, const Formula &reference_pressure);

    /// Write the contact surfaces of a load step that was not solved, as failed_STEP.pvtu, unless
    /// settings.vtu is false. Throws OutputError. Collective.
    /// @param snapshot the last iterate
    void
    write_failure(const Snapshot<dim> &snapshot);

    /// Restore the records of a run that is continued.
    /// @param times time and number of each load step that has files
    void
    restore(const std::vector<std::pair<double, unsigned int>> &times);

  private:
    const OutputSettings<dim> settings;
    const std::string         directory;
    PvdRecord                 bodies, contact;
  };
} // namespace Signorini
