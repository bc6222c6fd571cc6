// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/configuration.h"

#include <string>
#include <vector>

namespace Signorini
{
  /// True if an obstacle that moves in one increment would tunnel through a surface that stays
  /// where it is. Contact would then be detected on its far side, since points of the surface are
  /// inside of the obstacle on the way and face its own surface there; or not at all, if no point
  /// inside faces its surface, as where the middle of a ball has reached a plane. Collective.
  /// @param from configuration of surface and obstacle before the increment
  /// @param to displacement with the obstacle's rigid motion after the increment
  template <int dim>
  bool
  obstacle_tunnels(const Configuration<dim> &from,
                   const LA::Vector         &to,
                   const std::string        &surface,
                   const Obstacle<dim>      &obstacle);

  /// True if the surface lies inside of the obstacle somewhere, by more than a fifth of a cell.
  /// Collective.
  /// @param is_seen flags by the number of the face on this rank: where set, the contact search
  /// covers the face and decides; the other faces count only if they were outside in the reference
  /// configuration. Empty: no face is covered
  template <int dim>
  bool
  penetrates_obstacle(const Configuration<dim> &now,
                      const std::string        &surface,
                      const Obstacle<dim>      &obstacle,
                      const std::vector<bool>  &is_seen);

  /// True if the obstacle lies inside of the body of the surface, by more than half a cell, where
  /// it is closest to the surface. An obstacle that is smaller than the faces may get there past
  /// all contact points. Collective.
  template <int dim>
  bool
  encloses_obstacle(const Configuration<dim> &now,
                    const std::string        &surface,
                    const Obstacle<dim>      &obstacle);
} // namespace Signorini
