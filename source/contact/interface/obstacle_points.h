// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/pairing.h"
#include "contact/search/configuration.h"
#include <signorini/contact/obstacles/obstacle.h>

#include <vector>

namespace Signorini
{
  /// The points of slave faces that have a projection on a rigid obstacle: no mesh, no search, no
  /// segments.
  /// @param slave where it is now
  /// @param limit farther projections than that are none
  template <int dim>
  std::vector<PairedPoint<dim>>
  obstacle_points(const Configuration<dim>          &configuration,
                  const std::vector<FacePatch<dim>> &slave,
                  const Obstacle<dim>               &obstacle,
                  const Integration                 &integration,
                  double                             limit);
} // namespace Signorini
