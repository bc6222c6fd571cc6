// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include "output/pvd.h"
#include <signorini/scene/output_settings.h>

#include <string>

namespace Signorini
{
  /// Write solution_NNNN.pvtu and its pieces (NNNN is the step). At reference positions:
  /// `displacement`, `von_mises`, `stress` (three-dimensional, with sigma_zz in 2D: nine
  /// components, positive in tension; at a node the mean over the cells of a material around it),
  /// `principal_stress_1` (the largest) to `_3`, and for each cell `body` (its name in the field
  /// data `body_names`) and `subdomain` (the rank). Throws OutputError. Collective.
  /// @param snapshot the solution
  /// @param directory in which files are written
  /// @param with_strain whether `strain` (nine components, see Elasticity::strain()) and
  /// `principal_strain_1` to `_3` are added
  /// @return the name of the record
  template <int dim>
  std::string
  write_bodies(const Snapshot<dim> &snapshot,
               const std::string   &directory,
               bool                 with_strain = false);

  /// Write NAME_NNNN.pvtu and its pieces (NNNN is the step): the slave faces of all pairs at
  /// reference positions, with `displacement`, `traction` (force on the slave per area), `pressure`
  /// (positive in compression), `gap` (NaN where no master surface was found), `status` (1 active,
  /// 0 not, 2 alternating), and `pair` (a number from 0, with its name in the field data
  /// `pair_names`). A face of two pairs occurs twice. Throws OutputError. Collective.
  /// @param snapshot the solution
  /// @param directory in which files are written
  /// @param name of the files
  /// @return the name of the record NAME_NNNN.pvtu
  template <int dim>
  std::string
  write_contact(const Snapshot<dim> &snapshot,
                const std::string   &directory,
                const std::string   &name = "contact");

  /// Write step-NNNN/PAIR.csv for each pair (NNNN is the step), and a copy PAIR.csv, which is
  /// therefore that of the last step. Each line is a contact point (row of the gap operator):
  /// x,y,z,pressure,gap,status,initial_gap,normal_x,normal_y,normal_z[,reference], sorted by x,
  /// then y, then z. z is 0 in 2D; pressure is positive in compression; the normal is the direction
  /// of the force on the slave. Throws OutputError. Collective.
  /// @param snapshot the solution
  /// @param directory in which files are written
  /// @param reference_pressure formula of the coordinates and the time; empty: there is no such
  /// column
  template <int dim>
  void
  write_profiles(const Snapshot<dim> &snapshot,
                 const std::string   &directory,
                 const Formula       &reference_pressure);

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
