// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <vector>

namespace Signorini
{
  /// Gap [length, positive where open] and Cauchy pressure [stress, positive in compression] at the
  /// contact points of one pair on this rank, one entry for each point, independent of where the
  /// method samples.
  struct PointValues
  {
    std::vector<double> gap, pressure;
  };

  /// @return the values at the contact points. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  template <int dim>
  PointValues
  point_values(const Snapshot<dim> &snapshot, unsigned int pair);
} // namespace Signorini
