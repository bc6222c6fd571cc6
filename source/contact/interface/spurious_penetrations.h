// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"

#include <vector>

namespace Signorini
{
  /// Takes points out of the list that lie behind their projection without overlapping with its
  /// body.
  ///
  /// A point behind a face that faces it overlaps with the body if it is inside, and if that is
  /// the way out: an overlap is resolved along its least depth. Beyond a plate, points are behind
  /// the plate's other side; of two blocks that overlap a little, the left side of the one is
  /// behind the right side of the other, as far as these are broad. The way out is where points
  /// are about as far from the closest place of the surface as from their projection; near edges
  /// they are not, and follow those of the same direction.
  ///
  /// Collective.
  template <int dim>
  void
  drop_spurious_penetrations(const std::vector<FacePatch<dim>> &slave,
                             const MasterFaces<dim>            &master,
                             MPI_Comm                           comm,
                             SearchStatistics                  &statistics,
                             std::vector<PairedPoint<dim>>     &points);
} // namespace Signorini
