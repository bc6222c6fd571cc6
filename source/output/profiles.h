// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <string>

namespace Signorini
{
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
} // namespace Signorini
