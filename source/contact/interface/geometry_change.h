// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"

namespace Signorini
{
  /// The error of a small-sliding solution, which evaluates contact in the reference configuration:
  /// how much gaps and normals in the displaced configuration differ from it. Means weighted by the
  /// contact force.
  struct GeometryChange
  {
    double gap      = 0; ///< true gap minus the linear one, root of the mean square [length]
    double angle    = 0; ///< angle between the normals, root of the mean square [radian]
    double pressure = 0; ///< estimated change of the contact pressure, relative to its mean
  };

  /// Estimate the geometry error of one pair. A gap error d over a contact of width a is closed by
  /// a pressure of about E d/a (half space). A normal that is wrong by an angle rotates that part
  /// of the force into the surface, where it displaces the half space normally by at most (1 - 2
  /// nu)/(2 - 2 nu), or half, of what a pressure would (Johnson, Contact Mechanics (1985) 3.6).
  /// Collective.
  /// @param now the displaced configuration
  /// @param obstacle null if the master is a boundary of a body
  /// @param surface in the reference configuration
  /// @param forces the contact force at each of its points
  template <int dim>
  GeometryChange
  geometry_change(const Configuration<dim>  &now,
                  const ContactPair<dim>    &pair,
                  const Obstacle<dim>       *obstacle,
                  const ContactSurface<dim> &surface,
                  const std::vector<double> &forces);
} // namespace Signorini
