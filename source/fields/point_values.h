// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <vector>

namespace Signorini
{
  /// Gap and pressure at the contact points of one pair on this rank, whatever the method samples:
  /// the gap of the displacement there, and the pressure as interpolated from the nodes.
  struct PointValues
  {
    std::vector<double> gap, pressure;
  };

  /// Collective.
  template <int dim>
  PointValues
  point_values(const Snapshot<dim> &snapshot, unsigned int pair);
} // namespace Signorini
