// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

namespace Signorini
{
  /// The smallest side of the intersection of two boxes; bodies inside of them penetrate each other
  /// no deeper than that along an axis. 0 if they are disjoint.
  template <int dim>
  double
  common_depth(const dealii::BoundingBox<dim> &a, const dealii::BoundingBox<dim> &b);

  /// True if the bounding boxes of the bodies of a pair allow their surfaces to penetrate each
  /// other in the reference configuration.
  template <int dim>
  bool
  may_overlap(const Mesh<dim> &mesh, const ContactPair<dim> &pair);

  /// The depth of the slave of a pair inside of its master in the reference configuration, if it
  /// exceeds the search radius somewhere; else 0 [length]. A penetration is contact however deep it
  /// is. Only the middles of slave faces are checked, since the depth changes little over a face;
  /// with bodies only where the bounding boxes allow such a penetration. Collective.
  /// @param distance search radius [length]
  /// @param obstacle null if the master is a boundary of a body
  template <int dim>
  double
  penetration_beyond(double                    distance,
                     const Elasticity<dim>    &elasticity,
                     const ContactPair<dim>   &pair,
                     const Obstacle<dim>      *obstacle,
                     const BoundaryFaces<dim> &slave);
} // namespace Signorini
