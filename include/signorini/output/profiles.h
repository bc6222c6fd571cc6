#pragma once

#include <signorini/output/snapshot.h>

#include <string>

namespace Signorini
{
  /// Writes PAIR.csv for each pair, one line a contact point (row of the gap operator):
  /// x,y,z,pressure,gap,status[,reference], sorted by x, then y, then z. z is 0 in 2D; pressure is
  /// positive in compression. Overwrites the files of the step before. Collective.
  /// @param reference_pressure formula of the coordinates and the time; empty: no such column
  template <int dim>
  void
  write_profiles(const Snapshot<dim> &snapshot,
                 const std::string   &directory,
                 const Formula       &reference_pressure);
} // namespace Signorini
