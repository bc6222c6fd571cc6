// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

namespace Signorini
{
  /// The search radius of a pair [length]: its search distance if it has one; otherwise a tenth of
  /// the size of the model, so that initial penetrations are found, and at least `candidate_gap`,
  /// the gap up to which slave faces are candidates for contact. That gap is estimated before the
  /// first solution and checked after each.
  template <int dim>
  double
  search_radius_of_pair(const Elasticity<dim>  &elasticity,
                        const ContactPair<dim> &pair,
                        double                  candidate_gap);

  /// True if the bounding boxes of the two surfaces of a pair are farther apart than `distance`.
  /// Collective.
  /// @param obstacle null if the master is a boundary of a body
  template <int dim>
  bool
  is_apart(const Elasticity<dim>    &elasticity,
           const ContactPair<dim>   &pair,
           const Obstacle<dim>      *obstacle,
           const BoundaryFaces<dim> &slave,
           double                    distance);

  /// The bounding box of the faces of all ranks. Collective.
  template <int dim>
  dealii::BoundingBox<dim>
  box_of(const std::vector<FacePatch<dim>> &patches, MPI_Comm comm);

  /// Upper bound of the displacement of an obstacle's points within the model [length]. Collective.
  template <int dim>
  double
  largest_displacement(const Elasticity<dim> &elasticity,
                       const Obstacle<dim>   &obstacle,
                       const LA::Vector      &u);

  /// The largest displacement of the nodes of each boundary [length], by boundary id. Collective.
  template <int dim>
  std::vector<double>
  largest_displacements(const Elasticity<dim> &elasticity, const LA::Vector &u);

  /// Upper bound of the approach of the surfaces of a pair due to the displacement u [length].
  /// Collective.
  /// @param of_boundaries largest_displacements()
  template <int dim>
  double
  largest_approach(const Elasticity<dim>     &elasticity,
                   const ContactPair<dim>    &pair,
                   const Obstacle<dim>       *obstacle,
                   const LA::Vector          &u,
                   const std::vector<double> &of_boundaries);
} // namespace Signorini
