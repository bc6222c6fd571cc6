// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/configuration.h"

#include <string>
#include <vector>

namespace Signorini
{
  /// Would an obstacle that moves at once go through a surface that stays where it is? Contact
  /// would then be looked for on its other side: points of the surface are, on the way, inside of
  /// the obstacle, and look as its own surface does there; or nowhere, if none of those inside sees
  /// its surface, as where the middle of a ball has come to a plane. Collective.
  /// @param from where surface and obstacle are
  /// @param to the displacement that has the obstacle's motion
  template <int dim>
  bool
  obstacle_tunnels(const Configuration<dim> &from,
                   const LA::Vector         &to,
                   const std::string        &surface,
                   const Obstacle<dim>      &obstacle);

  /// Is the surface in the obstacle somewhere, by more than a fifth of a cell? Collective.
  /// @param is_seen by the number of the face on this rank: contact is looked for there, which
  /// knows better, and other parts count only if they were outside at rest; empty: nowhere
  template <int dim>
  bool
  penetrates_obstacle(const Configuration<dim> &now,
                      const std::string        &surface,
                      const Obstacle<dim>      &obstacle,
                      const std::vector<bool>  &is_seen);

  /// Is the obstacle in the body of the surface, by more than half a cell, where it is closest to
  /// the surface? Where it is smaller than the faces, it may get there past all points of the
  /// surface. Collective.
  template <int dim>
  bool
  encloses_obstacle(const Configuration<dim> &now,
                    const std::string        &surface,
                    const Obstacle<dim>      &obstacle);
} // namespace Signorini
