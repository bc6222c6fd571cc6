// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

namespace Signorini
{
  /// Make the segment edge points for geometric_stiffness(), complete but for the multiplier shape
  /// functions.
  /// @param paired with weights of reference areas
  template <int dim>
  std::vector<EdgeContactPoint<dim>>
  make_edge_points(const Elasticity<dim>               &elasticity,
                   const BoundaryFaces<dim>            &slave,
                   const std::vector<PairedPoint<dim>> &paired);
} // namespace Signorini
