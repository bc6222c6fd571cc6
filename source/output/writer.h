// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include "output/pvd.h"
#include <signorini/scene/output_settings.h>

#include <string>

namespace Signorini
{
  /// Writes the files that can be looked at: in `directory` solution.pvd and contact.pvd with one
  /// entry a step (unless settings.vtu is false), and the profiles of each step.
  template <int dim>
  class Writer
  {
  public:
    /// @param directory is there, see OutputDirectory
    Writer(const OutputSettings<dim> &settings, const std::string &directory, MPI_Comm comm);

    /// @param reference_pressure formula, written beside the pressure in profiles; may be empty.
    /// Collective.
    void
    write(const Snapshot<dim> &snapshot, const Formula &reference_pressure);

    /// Only the contact surfaces, as failed_STEP.pvtu, unless settings.vtu is false. Collective.
    void
    write_failure(const Snapshot<dim> &snapshot);

    /// Of a run that goes on: the load steps that have their files.
    /// @param times of each, and its number
    void
    restore(const std::vector<std::pair<double, unsigned int>> &times);

  private:
    const OutputSettings<dim> settings;
    const std::string         directory;
    PvdRecord                 bodies, contact;
  };
} // namespace Signorini
