// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/pressure_functions.h"
#include "contact/interface/pairing.h"
#include "contact/interface/surface.h"
#include "contact/search/boundary_faces.h"
#include "contact/search/configuration.h"
#include "contact/search/search.h"
#include <signorini/contact/master_image.h>
#include <signorini/contact/obstacles/obstacle.h>
#include <signorini/contact/pair.h>

#include <utility>
#include <vector>

namespace Signorini
{
  /// make_contact_surface() in a single pass, with slave and master as given. Throws SceneError
  /// where gaps are not numbers, initial penetrations exceed the search distance, an obstacle has
  /// no closest-point projection, or the displacement of slave faces is prescribed. Collective.
  /// @param fixed_points integration points to be projected again; empty on all ranks: new points
  template <int dim>
  ContactSurface<dim>
  single_pass_surface(const Configuration<dim>                      &configuration,
                      const ContactPair<dim>                        &pair,
                      const Obstacle<dim>                           *obstacle,
                      const ContactMethod                           &method,
                      const Integration                             &integration,
                      const SearchTolerance                         &range,
                      const std::vector<FixedIntegrationPoint<dim>> &fixed_points);

  /// Throws SceneError on all ranks if a prescribed gap is not a finite number. Collective.
  template <int dim>
  void
  check_gaps(const ContactPair<dim>               &pair,
             const std::vector<ContactPoint<dim>> &points,
             const MPI_Comm                        comm);

  /// Folded cells have no stress. Throws SolverFailure. Collective.
  template <int dim>
  void
  check_stresses(const std::vector<ContactPoint<dim>> &points, const MPI_Comm comm);

  /// Throws SceneError if surfaces penetrate each other in the reference configuration by more
  /// than their search distance.
  template <int dim>
  void
  check_search_distance(const double overlap, const ContactPair<dim> &pair);

  /// Throws SceneError on all ranks if an obstacle given by a formula of the gap is used in a
  /// displaced configuration although the formula is no distance from its surface. Collective.
  template <int dim>
  void
  check_obstacle(const Configuration<dim> &configuration,
                 const ContactPair<dim>   &pair,
                 const Obstacle<dim>      &obstacle,
                 const BoundaryFaces<dim> &slave);

  /// The nodes of the slave faces that have contact points; the entries of other faces are empty.
  /// @param functions result of set_pressure_functions()
  template <int dim>
  std::vector<SlaveFace<dim>>
  slave_faces(const Elasticity<dim>                &elasticity,
              const BoundaryFaces<dim>             &slave,
              const std::vector<ContactPoint<dim>> &points,
              const std::vector<PressureNodes>     &functions);

  /// True if any of the faces has a node without pressure, see SlaveFace::without_pressure.
  template <int dim>
  bool
  any_dirichlet_node(const std::vector<SlaveFace<dim>> &faces);

  /// (shape functions, area) at Gauss points of all slave faces in the reference configuration, see
  /// ContactSurface::full_face_shapes.
  template <int dim>
  std::vector<std::pair<SparseRow, double>>
  full_face_shape_functions(const Elasticity<dim> &elasticity, const BoundaryFaces<dim> &slave);

  /// The master side of a pair: its faces, and a function that completes a projection by what
  /// depends on the body: shape functions, stiffness, and in displaced configurations the second
  /// variation of the gap (without its factors).
  /// @param boundary BoundaryFaces::of_master() @param image the same that it is of
  /// @param method also the stress, for Nitsche's method
  template <int dim>
  MasterFaces<dim>
  master_faces(const Configuration<dim> &configuration,
               const BoundaryFaces<dim> &boundary,
               const MasterImage<dim>   &image,
               const ContactMethod      &method);

  /// Project the quadrature points of slave faces onto a rigid obstacle. That needs no mesh, no
  /// search and no segments.
  /// @param slave faces in the current configuration
  /// @param limit search radius [length]
  /// @param with_motion also the motion of the obstacle at the points, for the slip
  /// @return the points with a projection, sorted by slave faces
  template <int dim>
  std::vector<PairedPoint<dim>>
  obstacle_points(const Configuration<dim> &configuration,
                  const BoundaryFaces<dim> &slave,
                  const Obstacle<dim>      &obstacle,
                  const Integration        &integration,
                  double                    limit,
                  bool                      with_motion);

  /// Drop points of negligible weight: segments that only share a line with a face have no area.
  template <int dim>
  void
  drop_empty_points(const std::vector<FacePatch<dim>> &slave,
                    std::vector<PairedPoint<dim>>     &points);

  /// Keep the points of candidate faces, those with a point whose gap is at most `candidate_gap`
  /// (so penetrating ones in any case), and drop all others.
  template <int dim>
  void
  keep_candidates(double                          candidate_gap,
                  const BoundaryFaces<dim>       &slave,
                  std::vector<PairedPoint<dim>>  &paired,
                  std::vector<ContactPoint<dim>> &points);

  /// For pairs without separation: keep the points that touch in the reference configuration up to
  /// the discretisation error of the mesh, or that are within the search distance of the pair.
  /// Positive gaps stay as they are, penetrations are set to zero.
  template <int dim>
  void
  keep_zero_gap_points(const ContactPair<dim>         &pair,
                       const BoundaryFaces<dim>       &slave,
                       std::vector<PairedPoint<dim>>  &paired,
                       std::vector<ContactPoint<dim>> &points);

  /// True if the settings of a pair refer to gaps in the reference configuration: a prescribed
  /// initial gap, an interference whose share changes, or a pair without separation.
  template <int dim>
  bool
  needs_reference_gaps(const ContactPair<dim> &pair);

  /// The reference gaps of paired points [length]. Points that had no projection in the reference
  /// configuration are removed from `paired`. Collective.
  /// @param obstacle null if the master is a boundary of a body
  /// @param limit search radius [length]
  template <int dim>
  std::vector<double>
  reference_gaps(const Elasticity<dim>         &elasticity,
                 const ContactPair<dim>        &pair,
                 const Obstacle<dim>           *obstacle,
                 const BoundaryFaces<dim>      &slave,
                 double                         limit,
                 std::vector<PairedPoint<dim>> &paired);

  /// Make the segment edge points for geometric_stiffness(), complete but for the multiplier shape
  /// functions.
  /// @param paired with weights of reference areas
  template <int dim>
  std::vector<EdgeContactPoint<dim>>
  make_edge_points(const Elasticity<dim>               &elasticity,
                   const BoundaryFaces<dim>            &slave,
                   const std::vector<PairedPoint<dim>> &paired);

  /// Compare slave and master at the paired points, and set the results in the surface: mean face
  /// sizes, share of non-matching nodes, ratios of moduli and sizes. Collective.
  /// @param is_obstacle the master is rigid: then both sides count as alike, and no nodes match
  template <int dim>
  void
  compare(const Elasticity<dim>               &elasticity,
          const BoundaryFaces<dim>            &slave,
          const std::vector<PairedPoint<dim>> &paired,
          bool                                 is_obstacle,
          ContactSurface<dim>                 &surface);
} // namespace Signorini
