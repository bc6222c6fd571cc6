// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/pressure_basis.h"
#include "contact/search/search.h"

#include <deal.II/base/quadrature.h>

#include <vector>

namespace Signorini
{
  /// The quadrature rules on whole slave faces, for integration without segments.
  template <int dim>
  struct FaceRules
  {
    explicit FaceRules(const Integration &integration);

    /// The rule of a face.
    const dealii::Quadrature<dim - 1> &
    of(const FacePatch<dim> &face) const
    {
      return is_triangle(face.reference_cell()) ? of_triangles : of_hypercubes;
    }

    dealii::Quadrature<dim - 1> of_hypercubes, of_triangles;
  };

  /// A point of a slave face and its projection on the master.
  template <int dim>
  struct PairedPoint
  {
    unsigned int           face;   ///< number of the slave face on this rank
    dealii::Point<dim - 1> xi;     ///< its parameter there
    double                 weight; ///< quadrature weight times area of the slave [area]
    MasterProjection<dim>  master_point;
    /// The point does not lie above the face of its projection, but above another one.
    bool is_beside = false;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      serialize_bytes(ar, face);
      serialize_bytes(ar, xi);
      serialize_bytes(ar, weight);
      serialize_bytes(ar, is_beside);
      ar &master_point;
    }
  };

  /// The paired points of a surface, sorted by slave faces.
  template <int dim>
  struct Pairing
  {
    std::vector<PairedPoint<dim>> points;
    /// Points of segment edges, see second_variation_of_edge(). Their weight is the area that an
    /// outward shift of the edge by 1 adds. Set only in displaced configurations and with
    /// integration by segments.
    std::vector<PairedPoint<dim>> edge_points;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &points &edge_points;
    }
  };

  /// An integration point on a slave face that is kept from an earlier search, with the master face
  /// that its projection was on.
  template <int dim>
  struct FixedIntegrationPoint
  {
    unsigned int            face; ///< number of the slave face on this rank
    dealii::Point<dim - 1>  xi;
    double                  weight; ///< quadrature weight times reference area of the slave
    PreviousMasterFace<dim> former; ///< the master face of the earlier projection
  };

  /// The slave faces of this rank. Refers to its arguments. Converts implicitly from faces alone.
  template <int dim>
  struct SlaveSide
  {
    const std::vector<FacePatch<dim>> &patches;
    /// The faces in the reference configuration if slave and master are the same surface; null if
    /// they are two.
    const std::vector<FacePatch<dim>> *rest = nullptr;

    SlaveSide(const std::vector<FacePatch<dim>> &patches,
              const std::vector<FacePatch<dim>> *rest = nullptr)
      : patches(patches)
      , rest(rest)
    {}
  };

  /// Find the quadrature points on slave faces that have a projection on the master. Rule `nodes`:
  /// Gauss-Lobatto points, which are the nodes of the finite element. Rule `quadrature`: Gauss
  /// points. Rule `segments`: Gauss points on each segment (see segment_points()), projected onto
  /// the master face of the segment. Where surfaces are curved and far from each other, the closest
  /// point of such a point may be on the next face; then that is its projection, since the edge of
  /// the first face would otherwise be the projection of many points.
  ///
  /// If several layers of master faces lie opposite a slave face within the limit, segments cover
  /// it more than once. Segments that are farther than the nearest one by more than a face are then
  /// dropped; if the face is still covered more than once, it is paired by Gauss points, each of
  /// which takes the nearest layer.
  ///
  /// Points are sorted by slave faces. Faces take part as a whole or not at all, see
  /// keep_near_faces(). Collective.
  /// @param limit search radius [length]
  /// @param statistics counters to be added to
  /// @return the paired points of the slave faces of this rank
  template <int dim>
  Pairing<dim>
  pair_points(const SlaveSide<dim>   &slave,
              const MasterFaces<dim> &master,
              const Integration      &integration,
              double                  limit,
              MPI_Comm                comm,
              SearchStatistics       &statistics);

  /// Project given integration points again, preferably onto the master faces that they had before:
  /// so the quadrature rule does not change while the geometry update converges. Collective.
  /// @param fixed_points points of an earlier search
  /// @param limit search radius [length]
  /// @return those of the points that have a projection
  template <int dim>
  std::vector<PairedPoint<dim>>
  reproject_points(const SlaveSide<dim>                          &slave,
                   const std::vector<FixedIntegrationPoint<dim>> &fixed_points,
                   const MasterFaces<dim>                        &master,
                   double                                         limit,
                   MPI_Comm                                       comm,
                   SearchStatistics                              &statistics);

  /// A search radius for the points of a slave face [length]. The distance to the master changes
  /// over a face by no more than the diameter of the face, so this radius finds all points of a
  /// face of which one is within the limit.
  template <int dim>
  double
  search_radius(const FacePatch<dim> &slave, const double limit)
  {
    return limit + slave.diameter();
  }

  /// Drop the points of faces whose nearest projection is farther than the limit. Faces are kept or
  /// dropped as a whole, since a shape function weighted over part of its face would change its
  /// sign. Penetrating points always count as near, however deep.
  template <int dim>
  void
  keep_near_faces(const std::vector<FacePatch<dim>> &slave,
                  double                             limit,
                  std::vector<PairedPoint<dim>>     &points);

  /// Make integration points on the segments, the common parts of slave and master faces. Slave
  /// faces are sent to the ranks whose master faces may be near, and points are sent back. In the
  /// result, the points of one slave face need not be adjacent, and faces may be covered more than
  /// once. Collective.
  /// @param slave faces of this rank
  /// @param limit search radius [length]
  template <int dim>
  Pairing<dim>
  pair_by_segments(const SlaveSide<dim>   &slave,
                   const MasterFaces<dim> &master,
                   const Integration      &integration,
                   double                  limit,
                   MPI_Comm                comm,
                   SearchStatistics       &statistics);

  /// Remove points that lie behind their projection without penetrating its body.
  ///
  /// A point behind a face that faces it penetrates the body if it is inside, and if that face is
  /// on the shortest way out: a penetration is resolved along its smallest depth. Counter-examples:
  /// beyond a plate, points lie behind its other side; of two blocks with a small overlap, the left
  /// side of one lies behind the right side of the other, by the width of both. The criterion is
  /// that the distance to the closest point of the surface is about that to the projection. Near
  /// edges that fails, and points follow the others of the same direction.
  ///
  /// Collective.
  template <int dim>
  void
  drop_spurious_penetrations(const std::vector<FacePatch<dim>> &slave,
                             const MasterFaces<dim>            &master,
                             MPI_Comm                           comm,
                             SearchStatistics                  &statistics,
                             std::vector<PairedPoint<dim>>     &points);
} // namespace Signorini
