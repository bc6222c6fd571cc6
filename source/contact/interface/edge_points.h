// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

namespace Signorini
{
  /// The ends of segments as geometric_stiffness() wants them, all but the functions of the
  /// pressure.
  /// @param paired their weights are those of areas at rest
  template <int dim>
  std::vector<EdgeContactPoint<dim>>
  make_edge_points(const Elasticity<dim>               &elasticity,
                   const BoundaryFaces<dim>            &slave,
                   const std::vector<PairedPoint<dim>> &paired);
} // namespace Signorini
