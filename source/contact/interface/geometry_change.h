// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"

namespace Signorini
{
  /// What a solution with contact on surfaces at rest neglects: where bodies are pressed together,
  /// gaps and normals are others once they have moved. Means over the contact force.
  struct GeometryChange
  {
    double gap      = 0; ///< true gap minus the linear one, root of the mean square [length]
    double angle    = 0; ///< between the normals, likewise [radian]
    double pressure = 0; ///< what that may change of it, relative to its mean
  };

  /// Of one pair. A gap that is wrong by d over a contact of width a is closed by a pressure of
  /// about E d/a (the half space). A normal that is wrong by an angle turns that part of the force
  /// into the surface, where it moves the half space out or in at most by half of what a pressure
  /// would: (1 - 2 nu)/(2 - 2 nu), Johnson, Contact Mechanics (1985) 3.6. Collective.
  /// @param obstacle null if the master is a boundary of a body
  /// @param surface at rest
  /// @param forces of its points
  /// @param now where the bodies are
  template <int dim>
  GeometryChange
  geometry_change(const Configuration<dim>  &now,
                  const ContactPair<dim>    &pair,
                  const Obstacle<dim>       *obstacle,
                  const ContactSurface<dim> &surface,
                  const std::vector<double> &forces);
} // namespace Signorini
