#pragma once

#include <signorini/output/pvd.h>
#include <signorini/output/settings.h>
#include <signorini/output/snapshot.h>

#include <string>

namespace Signorini
{
  /// Writes the files that can be looked at: in `directory` solution.pvd and contact.pvd with one
  /// entry a step (unless settings.vtu is false), and profiles/PAIR.csv of the last step.
  template <int dim>
  class Writer
  {
  public:
    /// Creates the directories. Throws SceneError if that is impossible. Collective.
    Writer(const OutputSettings<dim> &settings, const std::string &directory, MPI_Comm comm);

    /// @param reference_pressure formula, written beside the pressure in profiles; may be empty.
    /// Collective.
    void
    write(const Snapshot<dim> &snapshot, const Formula &reference_pressure);

  private:
    const OutputSettings<dim> settings;
    const std::string         directory;
    PvdRecord                 bodies, contact;
  };
} // namespace Signorini
