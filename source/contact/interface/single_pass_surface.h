// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"

#include <vector>

namespace Signorini
{
  /// make_contact_surface() with the pair's slave and master as they are. Throws SceneError where
  /// gaps are not numbers, overlaps are beyond the search distance, obstacles have no closest
  /// points, or the displacement of slave faces is prescribed. Collective.
  /// @param fixed_points points of integration, or none on any rank: then they are chosen here
  template <int dim>
  ContactSurface<dim>
  single_pass_surface(const Configuration<dim>                      &configuration,
                      const ContactPair<dim>                        &pair,
                      const Obstacle<dim>                           *obstacle,
                      const ContactMethod                           &method,
                      const Integration                             &integration,
                      const SearchTolerance                         &range,
                      const std::vector<FixedIntegrationPoint<dim>> &fixed_points);
} // namespace Signorini
