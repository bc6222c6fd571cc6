// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"

namespace Signorini
{
  /// Make contact points of paired points, complete but for the multiplier shape functions.
  /// @param paired sorted by slave faces
  /// @param reference_gaps the reference gap of each point (see reference_gaps()); empty: the
  /// present gaps are the reference ones
  template <int dim>
  std::vector<ContactPoint<dim>>
  contact_points(const Configuration<dim>            &configuration,
                 const ContactPair<dim>              &pair,
                 const ContactMethod                 &method,
                 const BoundaryFaces<dim>            &slave,
                 const Integration                   &integration,
                 const std::vector<PairedPoint<dim>> &paired,
                 const std::vector<double>           &reference_gaps);

  /// The gap between a point and its projection [length], positive if open. Values within the
  /// rounding of the coordinates are set to zero: in models without loads they would be all that
  /// drives the solution.
  template <int dim>
  double
  gap_of(const dealii::Point<dim> &x, const MasterProjection<dim> &master_point);

  /// Convert the weights of paired points from current to reference areas, over which contact is
  /// integrated.
  template <int dim>
  void
  weigh_by_reference_area(const BoundaryFaces<dim> &slave, std::vector<PairedPoint<dim>> &paired);
} // namespace Signorini
