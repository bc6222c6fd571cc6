// SPDX-License-Identifier: Apache-2.0
#include "contact/search/search.h"

#include "contact/search/local_faces.h"
#include "geometry/extent.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <map>
#include <type_traits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Queries that are sent to other ranks, and the numbers of the points on this rank that they
    /// are about, in the same order.
    template <int dim>
    struct Outgoing
    {
      std::map<unsigned int, std::vector<Query<dim>>>   queries;
      std::map<unsigned int, std::vector<unsigned int>> points;
    };

    /// Select the queries for each other rank: those whose distance to the bounding box of the
    /// rank's master faces does not exceed the limit, which is reduced to the distance found on
    /// this rank (plus the tolerance of ties). A rank whose box is farther away cannot have a
    /// nearer face. Local; cost: number of points times number of ranks.
    template <int dim>
    Outgoing<dim>
    questions(const std::vector<Query<dim>>                  &queries,
              const std::vector<std::vector<Candidate<dim>>> &found,
              const std::vector<RankBox<dim>>                &ranks,
              const unsigned int                              this_rank)
    {
      Outgoing<dim> outgoing;
      for (unsigned int rank = 0; rank < ranks.size(); ++rank)
        {
          if (rank == this_rank || ranks[rank].empty)
            continue;
          for (unsigned int i = 0; i < queries.size(); ++i)
            {
              Query<dim> query = queries[i];
              if (!found[i].empty())
                query.limit = std::min(query.limit,
                                       found[i][0].master_point.distance +
                                         std::max(ranks[rank].tolerance, query.staying));
              if (distance(query.point, ranks[rank].box) > query.limit)
                continue;
              outgoing.queries[rank].push_back(query);
              outgoing.points[rank].push_back(i);
            }
        }
      return outgoing;
    }

    /// Send queries to the ranks whose master faces may be nearer, project the points of the
    /// queries received, and append the candidates that return. Two exchanges between neighbours
    /// (some_to_some) and one all_gather of boxes. Collective.
    template <int dim>
    void
    query_other_ranks(const std::vector<Query<dim>>            &queries,
                      LocalFaces<dim>                          &faces,
                      const MPI_Comm                            comm,
                      SearchStatistics                         &statistics,
                      std::vector<std::vector<Candidate<dim>>> &found)
    {
      // Number of the query within the message it came in, with its best candidate.
      using Answers = std::vector<std::pair<unsigned int, Candidate<dim>>>;
      static_assert(std::is_trivially_copyable<Query<dim>>::value, "queries are sent bit by bit");

      const auto ranks = Utilities::MPI::all_gather(comm, faces.extent());
      const auto outgoing =
        questions(queries, found, ranks, Utilities::MPI::this_mpi_process(comm));
      for (const auto &[rank, points] : outgoing.points)
        statistics.points_sent += points.size();

      // Each rank answers with at most one candidate, its best one; queries without any are not
      // answered.
      std::map<unsigned int, Answers> answers;
      for (const auto &[rank, asked] : Utilities::MPI::some_to_some(comm, outgoing.queries))
        for (unsigned int i = 0; i < asked.size(); ++i)
          if (std::optional<Candidate<dim>> c = faces.find(asked[i]))
            answers[rank].emplace_back(i, std::move(*c));

      for (const auto &[rank, received] : Utilities::MPI::some_to_some(comm, answers))
        for (const auto &[i, candidate] : received)
          found[outgoing.points.at(rank)[i]].push_back(candidate);
    }
  } // namespace



  template <int dim>
  bool
  cannot_self_contact(const ReferencePoint<dim> &a,
                      const ReferencePoint<dim> &b,
                      const double               width)
  {
    // Points on both sides of a thin wall have opposite normals, as touching parts have, but the
    // vector from one to the other points against the normals: (b - a).(n_b - n_a) > 0 means that
    // the body is between them. The bound is not zero since in a sheet that is rolled up the vector
    // between touching layers has a small component of that sign (the thickness over the length of
    // a turn). Points closer than two faces are neighbours, unless they face each other across a
    // narrow gap: with nearly opposite normals, and nothing of the body between them.
    constexpr double     inward = 0.3, across = 0.5;
    const Tensor<1, dim> way    = b.x - a.x;
    const double         length = way.norm(), into_body = way * (b.normal - a.normal) / 2;
    const bool           is_near = length <= 2 * width,
               faces_other       = a.normal * b.normal < -across && into_body < -across * length;
    return a.piece == b.piece && (is_near ? !faces_other : into_body > inward * length);
  }



  template <int dim>
  std::vector<std::optional<MasterProjection<dim>>>
  find_master_projections(const std::vector<Point<dim>>              &points,
                          const std::vector<Tensor<1, dim>>          &slave_normals,
                          const MasterFaces<dim>                     &master,
                          const double                                search_radius,
                          const MPI_Comm                              comm,
                          SearchStatistics                           *statistics,
                          const std::vector<PreviousMasterFace<dim>> &former,
                          const std::vector<ReferencePoint<dim>>     &rest)
  {
    // Another face replaces the former one only if it is closer by this share of the former's size.
    constexpr double staying = 1e-3;
    AssertDimension(points.size(), slave_normals.size());
    Assert(former.empty() || former.size() == points.size(),
           ExcDimensionMismatch(former.size(), points.size()));
    Assert(rest.empty() || rest.size() == points.size(),
           ExcDimensionMismatch(rest.size(), points.size()));
    SearchStatistics own_statistics;
    own_statistics.points = points.size();

    // First the faces of this rank, whose results limit what is sent to others.
    LocalFaces<dim>                          faces(master, own_statistics);
    std::vector<Query<dim>>                  queries(points.size());
    std::vector<std::vector<Candidate<dim>>> found(points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        queries[i] = {points[i], slave_normals[i], search_radius, Point<dim>(), 0, {}};
        if (!rest.empty())
          queries[i].rest = rest[i];
        if (!former.empty())
          {
            queries[i].former_center = former[i].center;
            queries[i].staying       = staying * former[i].size;
          }
        if (std::optional<Candidate<dim>> c = faces.find(queries[i]))
          found[i].push_back(std::move(*c));
      }
    if (Utilities::MPI::n_mpi_processes(comm) > 1)
      query_other_ranks(queries, faces, comm, own_statistics, found);

    // The nearest candidate of all ranks. A point beside its nearest face has no projection: it
    // lies beyond the edge of the surface.
    std::vector<std::optional<MasterProjection<dim>>> master_points(points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      if (const Candidate<dim> *best = nearest(found[i]))
        if (!best->overhangs)
          master_points[i] = best->master_point;
    if (statistics != nullptr)
      *statistics += own_statistics;
    return master_points;
  }



  template <int dim>
  std::vector<double>
  depths(const std::vector<Point<dim>> &points,
         const MasterFaces<dim>        &master,
         const double                   search_radius,
         const MPI_Comm                 comm,
         SearchStatistics              *statistics)
  {
    // Zero normals accept faces of any orientation; the closest point is then on the true boundary
    // of the body, and its normal says on which side of it the point is.
    const MasterFaces<dim>            faces{master.patches, [](auto, const auto &, auto &) {}};
    const std::vector<Tensor<1, dim>> any(points.size());
    const auto                        closest =
      find_master_projections(points, any, faces, search_radius, comm, statistics);
    std::vector<double> result;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!closest[i])
        result.push_back(std::numeric_limits<double>::infinity());
      else
        {
          const bool is_outside = (points[i] - closest[i]->position) * closest[i]->normal > 0;
          result.push_back((is_outside ? -1 : 1) * closest[i]->distance);
        }
    return result;
  }



  template std::vector<std::optional<MasterProjection<2>>>
  find_master_projections<2>(const std::vector<Point<2>> &,
                             const std::vector<Tensor<1, 2>> &,
                             const MasterFaces<2> &,
                             double,
                             MPI_Comm,
                             SearchStatistics *,
                             const std::vector<PreviousMasterFace<2>> &,
                             const std::vector<ReferencePoint<2>> &);
  template std::vector<std::optional<MasterProjection<3>>>
  find_master_projections<3>(const std::vector<Point<3>> &,
                             const std::vector<Tensor<1, 3>> &,
                             const MasterFaces<3> &,
                             double,
                             MPI_Comm,
                             SearchStatistics *,
                             const std::vector<PreviousMasterFace<3>> &,
                             const std::vector<ReferencePoint<3>> &);
  template bool
  cannot_self_contact(const ReferencePoint<2> &, const ReferencePoint<2> &, double);
  template bool
  cannot_self_contact(const ReferencePoint<3> &, const ReferencePoint<3> &, double);
  template std::vector<double>
  depths<2>(
    const std::vector<Point<2>> &, const MasterFaces<2> &, double, MPI_Comm, SearchStatistics *);
  template std::vector<double>
  depths<3>(
    const std::vector<Point<3>> &, const MasterFaces<3> &, double, MPI_Comm, SearchStatistics *);
} // namespace Signorini
