// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"

#include <vector>

namespace Signorini
{
  /// make_contact_surface() in a single pass, with slave and master as given. Throws SceneError
  /// where gaps are not numbers, initial penetrations exceed the search distance, an obstacle has
  /// no closest-point projection, or the displacement of slave faces is prescribed. Collective.
  /// @param fixed_points integration points to be projected again; empty on all ranks: new points
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
