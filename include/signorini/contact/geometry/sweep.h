#pragma once

#include <signorini/contact/geometry/configuration.h>

#include <string>

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
  goes_through(const Configuration<dim> &from,
               const LA::Vector         &to,
               const std::string        &surface,
               const Obstacle<dim>      &obstacle);

  /// Is the surface in the obstacle somewhere, by more than a fifth of a cell? Collective.
  template <int dim>
  bool
  is_within(const Configuration<dim> &now,
            const std::string        &surface,
            const Obstacle<dim>      &obstacle);
} // namespace Signorini
