// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

#include <vector>

namespace Signorini
{
  /// Compare slave and master at the paired points, and set the results in the surface: mean face
  /// sizes, share of non-matching nodes, ratios of moduli and sizes. Collective.
  /// @param is_obstacle the master is rigid: then both sides count as alike, and no nodes match
  template <int dim>
  void
  compare(const Elasticity<dim>               &elasticity,
          const BoundaryFaces<dim>            &slave,
          const std::vector<PairedPoint<dim>> &paired,
          bool                                 is_obstacle,
          ContactSurface<dim>                 &surface);
} // namespace Signorini
