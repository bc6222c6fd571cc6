// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"

#include <vector>

namespace Signorini
{
  /// Make integration points on the segments, the common parts of slave and master faces. Slave
  /// faces are sent to the ranks whose master faces may be near, and points are sent back. In the
  /// result, the points of one slave face need not be adjacent, and faces may be covered more than
  /// once. Collective.
  /// @param slave faces of this rank
  /// @param limit search radius [length]
  template <int dim>
  Pairing<dim>
  pair_by_segments(const SlaveSide<dim>   &slave,
                   const MasterFaces<dim> &master,
                   const Integration      &integration,
                   double                  limit,
                   MPI_Comm                comm,
                   SearchStatistics       &statistics);
} // namespace Signorini
