// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"
#include "contact/search/configuration.h"
#include <signorini/contact/obstacles/obstacle.h>

#include <vector>

namespace Signorini
{
  /// Project the quadrature points of slave faces onto a rigid obstacle. That needs no mesh, no
  /// search and no segments.
  /// @param slave faces in the current configuration
  /// @param limit search radius [length]
  /// @return the points with a projection, sorted by slave faces
  template <int dim>
  std::vector<PairedPoint<dim>>
  obstacle_points(const Configuration<dim>          &configuration,
                  const std::vector<FacePatch<dim>> &slave,
                  const Obstacle<dim>               &obstacle,
                  const Integration                 &integration,
                  double                             limit);
} // namespace Signorini
