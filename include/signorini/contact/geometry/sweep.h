#pragma once

#include <signorini/contact/geometry/configuration.h>

#include <string>

namespace Signorini
{
  /// Would an obstacle that moves at once go through a surface that stays where it is? Contact
  /// would then be looked for on its other side: points of the surface are, on the way, inside of
  /// the obstacle, and look as its own surface does there. Collective.
  /// @param from where surface and obstacle are
  /// @param to the displacement that has the obstacle's motion
  template <int dim>
  bool
  goes_through(const Configuration<dim> &from,
               const LA::Vector         &to,
               const std::string        &surface,
               const Obstacle<dim>      &obstacle);
} // namespace Signorini
