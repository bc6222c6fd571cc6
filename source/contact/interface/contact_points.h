// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

namespace Signorini
{
  /// The contact points of paired points, which are sorted by faces; all but the functions of the
  /// pressure.
  /// @param reference_gaps of the points, if they are needed (see reference_gaps()); else empty
  template <int dim>
  std::vector<ContactPoint<dim>>
  contact_points(const Configuration<dim>            &configuration,
                 const ContactPair<dim>              &pair,
                 const ContactMethod                 &method,
                 const BoundaryFaces<dim>            &slave,
                 const Integration                   &integration,
                 const std::vector<PairedPoint<dim>> &paired,
                 const std::vector<double>           &reference_gaps);

  /// The gap between a point and its projection. What touches up to the rounding of the coordinates
  /// touches: otherwise that rounding were all that drives a body without loads.
  template <int dim>
  double
  gap_of(const dealii::Point<dim> &x, const MasterProjection<dim> &master_point);

  /// From areas where the slave is now to areas at rest, which contact is integrated over.
  template <int dim>
  void
  weigh_by_reference_area(const BoundaryFaces<dim> &slave, std::vector<PairedPoint<dim>> &paired);
} // namespace Signorini
