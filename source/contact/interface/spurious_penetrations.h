// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"

#include <vector>

namespace Signorini
{
  /// Remove points that lie behind their projection without penetrating its body.
  ///
  /// A point behind a face that faces it penetrates the body if it is inside, and if that face is
  /// on the shortest way out: a penetration is resolved along its smallest depth. Counter-examples:
  /// beyond a plate, points lie behind its other side; of two blocks with a small overlap, the left
  /// side of one lies behind the right side of the other, by the width of both. The criterion is
  /// that the distance to the closest point of the surface is about that to the projection. Near
  /// edges that fails, and points follow the others of the same direction.
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
