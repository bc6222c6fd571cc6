// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

namespace Signorini
{
  /// The smallest side of what two boxes have in common: bodies in them overlap no deeper than that
  /// along an axis. 0 if they are apart.
  template <int dim>
  double
  common_depth(const dealii::BoundingBox<dim> &a, const dealii::BoundingBox<dim> &b);

  /// True if boxes of the bodies of a pair allow an overlap of its surfaces before anything moves.
  template <int dim>
  bool
  may_overlap(const Mesh<dim> &mesh, const ContactPair<dim> &pair);

  /// How deep the slave of a pair lies in its master before anything moves, if some of it is deeper
  /// than the distance within which projections are searched for; else 0. Overlaps are never too
  /// far apart to be contact, however large. The middles of slave faces are asked, which are as
  /// deep, and those of bodies only where boxes of both allow such an overlap. Collective.
  /// @param obstacle null if the master is a boundary of a body
  template <int dim>
  double
  penetration_beyond(double                    distance,
                     const Elasticity<dim>    &elasticity,
                     const ContactPair<dim>   &pair,
                     const Obstacle<dim>      *obstacle,
                     const BoundaryFaces<dim> &slave);
} // namespace Signorini
