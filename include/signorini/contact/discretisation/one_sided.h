#pragma once

#include <signorini/contact/discretisation/surface.h>

#include <vector>

namespace Signorini
{
  /// make_contact_surface() with the pair's slave and master as they are. Throws SceneError where
  /// gaps are not numbers, overlaps are beyond the search distance, obstacles have no closest
  /// points, or the displacement of slave faces is prescribed. Collective.
  /// @param least_limit as the limit there
  /// @param laid points of integration, or none on any rank: then they are chosen here
  template <int dim>
  ContactSurface<dim>
  one_sided_surface(const Configuration<dim>          &configuration,
                    const ContactPair<dim>            &pair,
                    const Obstacle<dim>               *obstacle,
                    const ContactMethod               &method,
                    const Integration                 &integration,
                    double                             reach,
                    double                             least_limit,
                    const std::vector<LaidPoint<dim>> &laid);
} // namespace Signorini
