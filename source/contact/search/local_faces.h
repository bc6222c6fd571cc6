// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/search.h"

#include <deal.II/numerics/rtree.h>

#include <optional>
#include <utility>
#include <vector>

namespace Signorini
{
  /// A slave point to be projected, as it is sent to the ranks of the master faces; it is copied
  /// byte by byte.
  template <int dim>
  struct Query
  {
    /// Position in the current configuration [length], and outward unit normal; a zero normal
    /// accepts faces of any orientation.
    dealii::Point<dim>     point;
    dealii::Tensor<1, dim> normal;
    /// Largest distance of a projection that is of interest [length].
    double limit;
    /// Center of the master face of an earlier projection, which is to be kept if it is no farther
    /// than `staying` beyond the nearest one [length]; 0: there is none.
    dealii::Point<dim> former_center;
    double             staying = 0;
    /// The point in the reference configuration, if slave and master are the same surface.
    ReferencePoint<dim> rest;

    // Required by the template that sends objects, but not called for types that are copied byte by
    // byte.
    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &point &normal &limit &former_center &staying &rest.x &rest.normal;
    }
  };

  /// A possible projection of a point: onto a face that faces the point and is within the limit.
  template <int dim>
  struct Candidate
  {
    MasterProjection<dim> master_point;
    /// Distances that differ by less count as equal [length].
    double tolerance;
    /// True if the point lies beside the face, not above it.
    bool overhangs;
    /// True if the face is the one of the earlier projection.
    bool is_former;
    /// Number of the face, and parameter on it; valid on the rank of the face only.
    unsigned int           face;
    dealii::Point<dim - 1> xi;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &master_point &tolerance &overhangs &is_former;
    }
  };

  /// The bounding box of the master faces of a rank, as it is announced to all ranks.
  template <int dim>
  struct RankBox
  {
    bool                     empty = true;
    dealii::BoundingBox<dim> box;
    /// The largest rounding tolerance of the rank's faces [length].
    double tolerance = 0;

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &empty &box &tolerance;
    }
  };

  /// The nearest candidate (nullptr if there is none), ties broken as find_master_projections()
  /// promises.
  template <int dim>
  const Candidate<dim> *
  nearest(const std::vector<Candidate<dim>> &candidates);

  /// The master faces of this rank in an R-tree. Keeps references to both arguments of the
  /// constructor.
  template <int dim>
  class LocalFaces
  {
  public:
    LocalFaces(const MasterFaces<dim> &master, SearchStatistics &statistics);

    /// The best candidate among the faces within the limit that face the point, completed if it can
    /// become the projection; nothing if there is none.
    std::optional<Candidate<dim>>
    find(const Query<dim> &query);

    /// Numbers of the faces whose boxes meet this one.
    std::vector<unsigned int>
    in(const dealii::BoundingBox<dim> &box) const;

    /// The bounding box of the faces of this rank.
    const RankBox<dim> &
    extent() const
    {
      return rank_box;
    }

  private:
    /// The normal in the middle of a face, and by how much the normals at its other points may
    /// differ from it.
    struct Normals
    {
      dealii::Tensor<1, dim> middle;
      double                 spread;
    };

    /// Bound the normals of a face, by which faces that cannot face a point are excluded.
    static Normals
    normals_of(const FacePatch<dim> &face);

    /// Project the point on one face; empty if it is not an admissible partner.
    std::optional<Candidate<dim>>
    candidate(const Query<dim> &query, const unsigned int face);

    double
    first_radius(const dealii::Point<dim> &x) const;

    /// Distance of the box, index: those with inner < distance <= outer, nearest first.
    const std::vector<std::pair<double, unsigned int>> &
    ring(const dealii::Point<dim> &x, double inner, double outer);

    using Tree = decltype(dealii::pack_rtree_of_indices(
      std::declval<std::vector<dealii::BoundingBox<dim>> &>()));

    const MasterFaces<dim>               &master;
    SearchStatistics                     &statistics;
    RankBox<dim>                          rank_box;
    std::vector<dealii::BoundingBox<dim>> boxes;
    Tree                                  tree;
    std::vector<Normals>                  normals;

    // Kept between queries to spare the heap.
    std::vector<Candidate<dim>>                  candidates;
    std::vector<std::pair<double, unsigned int>> in_ring;
  };
} // namespace Signorini
