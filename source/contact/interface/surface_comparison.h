// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

#include <vector>

namespace Signorini
{
  /// What slave and master are to each other at the points: sizes of faces, nodes that meet,
  /// moduli; set in the surface. Collective.
  /// @param is_obstacle then sides are alike, and no nodes meet
  template <int dim>
  void
  compare(const Elasticity<dim>               &elasticity,
          const BoundaryFaces<dim>            &slave,
          const std::vector<PairedPoint<dim>> &paired,
          bool                                 is_obstacle,
          ContactSurface<dim>                 &surface);
} // namespace Signorini
