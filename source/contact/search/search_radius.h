// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

namespace Signorini
{
  /// How far projections are searched for: the pair's search distance, or a tenth of the scene,
  /// where initial overlaps may be found, and at least the reach, the gap up to which slave faces
  /// are candidates for contact. The reach is guessed before the first solution and checked after
  /// each.
  template <int dim>
  double
  search_radius_of_pair(const Elasticity<dim>  &elasticity,
                        const ContactPair<dim> &pair,
                        double                  candidate_gap);

  /// True if bounding boxes already tell that two surfaces are farther apart than that. Collective.
  /// @param obstacle null if the master is a boundary of a body
  template <int dim>
  bool
  is_apart(const Elasticity<dim>    &elasticity,
           const ContactPair<dim>   &pair,
           const Obstacle<dim>      *obstacle,
           const BoundaryFaces<dim> &slave,
           double                    distance);

  /// Of faces on all ranks. Collective.
  template <int dim>
  dealii::BoundingBox<dim>
  box_of(const std::vector<FacePatch<dim>> &patches, MPI_Comm comm);

  /// Of a point of an obstacle in the scene, at most. Collective.
  template <int dim>
  double
  largest_displacement(const Elasticity<dim> &elasticity,
                       const Obstacle<dim>   &obstacle,
                       const LA::Vector      &u);

  /// Of the nodes of each boundary, by its id. Collective.
  template <int dim>
  std::vector<double>
  largest_displacements(const Elasticity<dim> &elasticity, const LA::Vector &u);

  /// By how much the surfaces of a pair can have come closer to each other with displacement u.
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
