// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_second_variation.h"
#include "contact/interface/pairing.h"
#include "contact/search/descent.h"
#include "contact/search/local_faces.h"
#include "contact/search/segments.h"
#include "contact/search/self_contact.h"
#include "geometry/face_parameter.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A point lies beside its master face if the tangential part of its distance is larger than
    /// this, in diameters of the face.
    constexpr double beside = 1e-3;

    /// True if a face is far from a parallelogram: its bilinear term exceeds a fifth of its
    /// diameter. Then the inverse maps of segments are far from linear, and segments get a rule of
    /// higher degree.
    template <int dim>
    bool
    is_distorted(const FacePatch<dim> &face)
    {
      if constexpr (dim == 3)
        {
          if (is_triangle(face.reference_cell()))
            return false;
          // Of the kites in an equilateral triangle it is 0.5.
          constexpr double     most   = 0.2;
          const Tensor<1, dim> defect = (face.position({0, 0}) - face.position({1, 0})) +
                                        (face.position({1, 1}) - face.position({0, 1}));
          return defect.norm() > most * face.diameter();
        }
      return false;
    }

    template <int dim>
    struct SegmentRules
    {
      SegmentRule<dim> usual, distorted;
      /// Number of points on each straight piece of a segment edge.
      unsigned int on_edges;
    };

    /// A slave face as it is sent to the ranks of master faces near it.
    template <int dim>
    struct TravellingFace
    {
      FacePatch<dim> patch;
      unsigned int   number; // on its own rank
      // Geometry in the reference configuration if slave and master are the same surface.
      FacePatch<dim> rest;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &patch &number &rest;
      }
    };

    template <typename T>
    void
    append(std::vector<T> &all, std::vector<T> &&more)
    {
      all.insert(all.end(),
                 std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
    }

    /// The part of v that is perpendicular to a unit normal.
    template <int dim>
    Tensor<1, dim>
    tangential_part(const Tensor<1, dim> &v, const Tensor<1, dim> &normal)
    {
      return v - (v * normal) * normal;
    }

    /// Closest point of a face by the projected Newton method from a given start; project() with
    /// its grid of starts where that does not converge. tangential_offset is set by the latter
    /// only.
    template <int dim>
    Projection<dim>
    project_from(const Point<dim> &x, const FacePatch<dim> &face, const Point<dim - 1> &start)
    {
      Projection<dim> result;
      result.xi                  = start;
      result.converged_by_newton = descend_to_minimum(x, face, result.xi);
      if (!result.converged_by_newton)
        return project(x, face);
      result.position = face.position(result.xi);
      result.distance = x.distance(result.position);
      return result;
    }

    /// Computes the segments of slave faces, of this rank or another, with the master faces of this
    /// rank. Master faces are found by an R-tree of their boxes. Refers to its arguments.
    template <int dim>
    class LocalSegments
    {
    public:
      LocalSegments(const MasterFaces<dim>  &master,
                    const SegmentRules<dim> &rules,
                    const double             limit,
                    SearchStatistics        &statistics)
        : master(master)
        , faceted(master.patches.begin(), master.patches.end())
        , faces(master, statistics)
        , rules(rules)
        , limit(limit)
        , statistics(statistics)
      {
        for (const FacePatch<dim> &face : master.patches)
          distorted.push_back(is_distorted(face));
      }

      const RankBox<dim> &
      extent() const
      {
        return faces.extent();
      }

      /// Append the points of all segments of a slave face: of each master face whose box meets
      /// that of the slave face extended by the search radius, the segments with each facet, their
      /// quadrature points and, in displaced configurations, the points of segment edges.
      void
      find(const TravellingFace<dim> &slave, Pairing<dim> &found)
      {
        const FacetedFace<dim> own(slave.patch);
        const bool             own_distorted = is_distorted(slave.patch);
        for (const unsigned int face :
             faces.in(own.extruded_box(search_radius(slave.patch, limit))))
          {
            for (const SegmentPoint<dim> &point :
                 segment_points(own,
                                faceted[face],
                                own_distorted || distorted[face] ? rules.distorted : rules.usual))
              if (auto pair = paired(slave, face, point))
                found.points.push_back(std::move(*pair));
            if (!master.inner_sides.empty())
              for (const SegmentEdgePoint<dim> &point :
                   segment_edge_points(own, faceted[face], rules.on_edges))
                add_edge_points(slave, face, point, found.edge_points);
          }
      }

    private:
      /// Project a point of a segment onto the master face of the segment, starting at the
      /// parameter that the segment has there; nothing if the projection is beyond the search
      /// radius, if the surfaces do not face each other, or if they cannot touch as parts of the
      /// same surface.
      std::optional<PairedPoint<dim>>
      paired(const TravellingFace<dim> &slave,
             const unsigned int         face,
             const SegmentPoint<dim>   &point)
      {
        const FacePatch<dim> &patch = master.patches[face];
        const Point<dim>      x     = slave.patch.position(point.slave);
        const Projection<dim> foot  = project_from(x, patch, point.master);
        ++statistics.projections;
        if (!foot.converged_by_newton)
          ++statistics.fallbacks;

        PairedPoint<dim> pair{slave.number, point.slave, point.weight, {}};
        pair.master_point.normal = patch.normal(foot.xi);
        pair.is_beside = tangential_part(x - foot.position, pair.master_point.normal).norm() >
                         beside * patch.diameter();
        if (foot.distance > search_radius(slave.patch, limit) ||
            !faces_each_other(slave.patch.normal(point.slave), pair.master_point.normal))
          return {};
        if (!master.rest.empty() && cannot_self_contact(slave, point.slave, face, foot.xi))
          return {};
        pair.master_point.position    = foot.position;
        pair.master_point.distance    = foot.distance;
        pair.master_point.face_center = patch.center();
        master.complete(face, foot.xi, pair.master_point);
        return pair;
      }

      bool
      cannot_self_contact(const TravellingFace<dim> &slave,
                          const Point<dim - 1>      &xi,
                          const unsigned int         face,
                          const Point<dim - 1>      &at) const
      {
        return Signorini::cannot_self_contact<dim>(reference_point(slave.rest, xi),
                                                   reference_point(master.rest[face], at),
                                                   master.rest[face].diameter());
      }

      /// Add a point of a segment edge with its second variation of the gap (doc/theory, (5.8)), if
      /// the surface continues behind that side of the master face and the point is close enough to
      /// carry pressure. At the rim of the master surface the domain of contact ends for good and
      /// the term is omitted.
      void
      add_edge_points(const TravellingFace<dim>     &slave,
                      const unsigned int             face,
                      const SegmentEdgePoint<dim>   &point,
                      std::vector<PairedPoint<dim>> &edge_points)
      {
        // The largest ratio of the distance along the slave's normal to the distance.
        constexpr double steepest = 10;
        if (!master.inner_sides[face][point.side])
          return;
        // Reject far points by a lower bound of their distance before the projection, which is the
        // expensive part.
        const FacePatch<dim> &patch = master.patches[face];
        if (!may_carry_pressure(
              slave.patch.position(point.slave).distance(patch.position(point.master)) / steepest,
              patch.diameter()))
          return;
        auto edge_point = paired(slave, face, point);
        if (!edge_point || !may_carry_pressure(edge_point->master_point.distance, patch.diameter()))
          return;
        edge_point->master_point.second_variation =
          second_variation_of_edge(edge_point->master_point.normal, point.outward);
        edge_points.push_back(std::move(*edge_point));
      }

      const MasterFaces<dim>             &master;
      const std::vector<FacetedFace<dim>> faceted;
      LocalFaces<dim>                     faces;
      std::vector<bool>                   distorted; ///< faces of the master
      const SegmentRules<dim>            &rules;
      const double                        limit;
      SearchStatistics                   &statistics;
    };
  } // namespace



  template <int dim>
  Pairing<dim>
  pair_by_segments(const SlaveSide<dim>   &slave,
                   const MasterFaces<dim> &master,
                   const Integration      &integration,
                   const double            limit,
                   const MPI_Comm          comm,
                   SearchStatistics       &statistics)
  {
    const unsigned int      n     = integration.n_points;
    const unsigned int      more  = std::max(n, integration.n_points_of_distorted);
    const SegmentRules<dim> rules = {SegmentRule<dim>(n), SegmentRule<dim>(more), n};
    LocalSegments<dim>      segments(master, rules, limit, statistics);
    Pairing<dim>            pairing;
    const auto              travelling = [&](const unsigned int i) {
      return TravellingFace<dim>{slave.patches[i],
                                 i,
                                 slave.rest ? (*slave.rest)[i] : FacePatch<dim>()};
    };
    // Faces of this rank with master faces of this rank need no communication.
    for (unsigned int i = 0; i < slave.patches.size(); ++i)
      segments.find(travelling(i), pairing);
    if (Utilities::MPI::n_mpi_processes(comm) == 1)
      return pairing;

    // Slave faces are sent to the ranks whose box of master faces meets their own extended box;
    // points return. Two exchanges between neighbours.
    const auto                    ranks = Utilities::MPI::all_gather(comm, segments.extent());
    std::vector<BoundingBox<dim>> boxes;
    for (const FacePatch<dim> &face : slave.patches)
      boxes.push_back(FacetedFace<dim>(face).extruded_box(search_radius(face, limit)));
    std::map<unsigned int, std::vector<TravellingFace<dim>>> outgoing;
    for (unsigned int rank = 0; rank < ranks.size(); ++rank)
      if (rank != Utilities::MPI::this_mpi_process(comm) && !ranks[rank].empty)
        for (unsigned int i = 0; i < slave.patches.size(); ++i)
          if (boxes[i].get_neighbor_type(ranks[rank].box) != NeighborType::not_neighbors)
            outgoing[rank].push_back(travelling(i));

    std::map<unsigned int, Pairing<dim>> answers;
    for (const auto &[rank, visitors] : Utilities::MPI::some_to_some(comm, outgoing))
      for (const TravellingFace<dim> &visitor : visitors)
        segments.find(visitor, answers[rank]);
    for (auto &[rank, found] : Utilities::MPI::some_to_some(comm, answers))
      {
        append(pairing.points, std::move(found.points));
        append(pairing.edge_points, std::move(found.edge_points));
      }
    return pairing;
  }



  template Pairing<2>
  pair_by_segments(const SlaveSide<2> &,
                   const MasterFaces<2> &,
                   const Integration &,
                   double,
                   MPI_Comm,
                   SearchStatistics &);
  template Pairing<3>
  pair_by_segments(const SlaveSide<3> &,
                   const MasterFaces<3> &,
                   const Integration &,
                   double,
                   MPI_Comm,
                   SearchStatistics &);
} // namespace Signorini
