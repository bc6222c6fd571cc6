// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"
#include "contact/search/master_projection.h"
#include "contact/search/projection.h"

#include <deal.II/base/mpi.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace Signorini
{
  /// True if two surfaces with these outward unit normals are opposite enough to touch.
  template <int dim>
  bool
  faces_each_other(const dealii::Tensor<1, dim> &slave_normal,
                   const dealii::Tensor<1, dim> &master_normal)
  {
    return slave_normal * master_normal < -0.1;
  }

  /// The master face of a point's earlier projection, identified by its center.
  template <int dim>
  struct PreviousMasterFace
  {
    dealii::Point<dim> center;
    double             size = 0; ///< diameter of the face; 0: there was no projection
  };

  /// The master side of one contact pair on this rank: the faces of its locally owned cells, and a
  /// function for the data that the geometric search does not have, shape functions and stiffness.
  template <int dim>
  struct MasterFaces
  {
    std::vector<FacePatch<dim>> patches;
    /// Completes a projection on face i at parameter xi, whose position and normal are set: fills
    /// in shape functions, rows, `stiffness` and `bound`.
    std::function<
      void(unsigned int i, const dealii::Point<dim - 1> &xi, MasterProjection<dim> &master_point)>
      complete;
    /// Flags of the sides of each face (2 d + (0 or 1): the side where parameter d is 0 or 1)
    /// behind which the surface continues. Empty if not needed.
    std::vector<std::array<bool, 2 * (dim - 1)>> inner_sides = {};
    /// The faces in the reference configuration if slave and master are the same surface; then
    /// projections that cannot_self_contact() are rejected. Empty if slave and master are two
    /// surfaces.
    std::vector<FacePatch<dim>> rest = {};
  };

  /// A point of a surface in the reference configuration.
  template <int dim>
  struct ReferencePoint
  {
    dealii::Point<dim>     x;
    dealii::Tensor<1, dim> normal;    ///< outward
    unsigned int           piece = 0; ///< see FacePatch::piece
  };

  /// True if two points of the same surface cannot touch each other: they belong to the same
  /// connected piece of the mesh, and are neighbours, or lie on two sides of it with nothing but
  /// the body itself between them in the reference configuration.
  /// @param width of the faces there [length]
  template <int dim>
  bool
  cannot_self_contact(const ReferencePoint<dim> &a, const ReferencePoint<dim> &b, double width);

  /// Counters of a search on this rank. `projections` includes those for points of other ranks.
  struct SearchStatistics
  {
    unsigned long points = 0, points_sent = 0, projections = 0, fallbacks = 0;

    SearchStatistics &
    operator+=(const SearchStatistics &other)
    {
      points += other.points;
      points_sent += other.points_sent;
      projections += other.projections;
      fallbacks += other.fallbacks;
      return *this;
    }
  };

  /// For each slave point of this rank, find the closest point on the master surface of all ranks,
  /// if there is one within `search_radius` that faces the point (see faces_each_other()) and does
  /// not lie beyond the edge of the surface. Collective.
  ///
  /// Points travel to the faces: every rank announces one bounding box of its master faces; points
  /// inside the inflated box are sent there and are projected onto the faces that an R-tree yields
  /// in the order of distance; the results are sent back. No rank ever receives faces of another.
  ///
  /// Ties (a point that projects onto the common edge of two faces) are broken in favour of the
  /// face whose center is lexicographically smaller, so that the result does not depend on the
  /// partition; but a face that the point lies above precedes one that it overhangs.
  ///
  /// Points whose normal is zero accept faces of any orientation. Points with an earlier face keep
  /// it as long as it is no farther than the nearest one plus 1e-3 of its size: at an edge between
  /// two faces the projection could otherwise alternate between them for ever.
  /// @param points positions of the slave points
  /// @param slave_normals their outward unit normals, or zero
  /// @param statistics counters to be added to; null: none
  /// @param former the earlier master face of each point, or empty
  /// @param rest the reference position of each point if `master` has reference faces, else empty
  /// @return the projection of each point, if it has one
  template <int dim>
  std::vector<std::optional<MasterProjection<dim>>>
  find_master_projections(const std::vector<dealii::Point<dim>>      &points,
                          const std::vector<dealii::Tensor<1, dim>>  &slave_normals,
                          const MasterFaces<dim>                     &master,
                          double                                      search_radius,
                          MPI_Comm                                    comm,
                          SearchStatistics                           *statistics = nullptr,
                          const std::vector<PreviousMasterFace<dim>> &former     = {},
                          const std::vector<ReferencePoint<dim>>     &rest       = {});

  /// The depth of each point of this rank inside the master's body, measured from the closest point
  /// of the surface of any orientation: positive inside, negative outside, infinity if nothing is
  /// within the radius. A point behind a face that faces it may also be beyond the whole body, as
  /// above a plate, whose lower side faces down as the point does. Collective.
  template <int dim>
  std::vector<double>
  depths(const std::vector<dealii::Point<dim>> &points,
         const MasterFaces<dim>                &master,
         double                                 search_radius,
         MPI_Comm                               comm,
         SearchStatistics                      *statistics = nullptr);
} // namespace Signorini
