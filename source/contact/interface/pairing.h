// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/pressure_basis.h"
#include "contact/search/search.h"

#include <deal.II/base/quadrature.h>

#include <vector>

namespace Signorini
{
  /// The points on a whole slave face (no segments).
  template <int dim>
  dealii::Quadrature<dim - 1>
  face_rule(const Integration &integration);

  /// A point of a slave face and its projection on the master.
  template <int dim>
  struct PairedPoint
  {
    unsigned int           face;   ///< number of the slave face on this rank
    dealii::Point<dim - 1> xi;     ///< its parameter there
    double                 weight; ///< area of the slave that it stands for
    MasterProjection<dim>  master_point;
    bool is_beside = false; ///< of the projection: not above it, but above another face

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

  /// The points of a surface that have a projection, face by face.
  template <int dim>
  struct Pairing
  {
    std::vector<PairedPoint<dim>> points;
    /// Points where segments end with their master face, see second_variation_of_edge(); their
    /// weight is the area that an outward step of 1 adds. Where surfaces have moved, by segments.
    std::vector<PairedPoint<dim>> edge_points;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &points &edge_points;
    }
  };

  /// A point of integration on a slave face, without a projection.
  template <int dim>
  struct FixedIntegrationPoint
  {
    unsigned int            face; ///< number of the slave face on this rank
    dealii::Point<dim - 1>  xi;
    double                  weight; ///< area of the slave at rest
    PreviousMasterFace<dim> former; ///< of the master
  };

  /// Faces of a slave on this rank. Converts from faces alone.
  template <int dim>
  struct SlaveSide
  {
    const std::vector<FacePatch<dim>> &patches;
    /// Where they were, if the master is the same surface; null: it is another.
    const std::vector<FacePatch<dim>> *rest = nullptr;

    SlaveSide(const std::vector<FacePatch<dim>> &patches,
              const std::vector<FacePatch<dim>> *rest = nullptr)
      : patches(patches)
      , rest(rest)
    {}
  };

  /// The points of quadrature on slave faces that have a projection. `nodes`: Gauss-Lobatto points,
  /// which are the nodes of the finite element; `quadrature`: Gauss points; `segments`: Gauss
  /// points on each segment (see segment_points()), with the projection on the segment's master
  /// face. Where surfaces are curved and far from each other, the closest place may be on the next
  /// face: it is the projection then, for the rim of the first one would be that of many points.
  ///
  /// A slave face that more than one layer of master faces lies opposite to, within the limit, is
  /// covered more than once by segments: those farther away by a face than the nearest are left
  /// out; if that is not enough, it is paired by Gauss points, which take the nearest layer.
  ///
  /// Points come face by face. Faces take part as a whole, or not at all, see keep_near_faces().
  /// Collective.
  template <int dim>
  Pairing<dim>
  pair_points(const SlaveSide<dim>   &slave,
              const MasterFaces<dim> &master,
              const Integration      &integration,
              double                  limit,
              MPI_Comm                comm,
              SearchStatistics       &statistics);

  /// The closest projections of points that are laid already, on the faces that they had before if
  /// these are as good: so the rule stays as it is while Newton's method moves the surfaces to
  /// where they balance. Collective.
  template <int dim>
  std::vector<PairedPoint<dim>>
  reproject_points(const SlaveSide<dim>                          &slave,
                   const std::vector<FixedIntegrationPoint<dim>> &fixed_points,
                   const MasterFaces<dim>                        &master,
                   double                                         limit,
                   MPI_Comm                                       comm,
                   SearchStatistics                              &statistics);

  /// Distances change by no more than its diameter on a face: this finds all points of a face that
  /// has one within the limit.
  template <int dim>
  double
  search_radius(const FacePatch<dim> &slave, const double limit)
  {
    return limit + slave.diameter();
  }

  /// Drop the points of faces whose nearest projection is beyond the limit. A shape function on a
  /// part of a face would be a weight that changes its sign. Points that lie behind their
  /// projection's face are near, however deep: an overlap is contact, whatever is expected to move.
  template <int dim>
  void
  keep_near_faces(const std::vector<FacePatch<dim>> &slave,
                  double                             limit,
                  std::vector<PairedPoint<dim>>     &points);
} // namespace Signorini
