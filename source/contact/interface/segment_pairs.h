// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"

#include <vector>

namespace Signorini
{
  /// Points of integration on the common parts of slave and master faces: slave faces travel to the
  /// ranks whose master faces may be near, points come back. Those of a face may be far from each
  /// other in the list, and faces may be covered more than once. Collective.
  /// @param slave faces of this rank
  /// @param limit up to which distance projections are looked for
  template <int dim>
  Pairing<dim>
  pair_by_segments(const SlaveSide<dim>   &slave,
                   const MasterFaces<dim> &master,
                   const Integration      &integration,
                   double                  limit,
                   MPI_Comm                comm,
                   SearchStatistics       &statistics);
} // namespace Signorini
