// SPDX-License-Identifier: Apache-2.0
#include "contact/interface/pairing.h"

#include "contact/search/self_contact.h"
#include "geometry/cell_rule.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A face is covered once if the weights of its points sum up to at most this times its area,
    /// which allows for the error of quadrature.
    constexpr double covered_once = 1 + 1e-4;

    /// The points of a rule on whole slave faces, weighted with the Jacobian of the face, without a
    /// former master face.
    /// @param faces numbers of the faces on this rank
    template <int dim>
    std::vector<FixedIntegrationPoint<dim>>
    make_integration_point(const std::vector<FacePatch<dim>> &slave,
                           const std::vector<unsigned int>   &faces,
                           const FaceRules<dim>              &rules)
    {
      std::vector<FixedIntegrationPoint<dim>> points;
      for (const unsigned int i : faces)
        {
          const Quadrature<dim - 1> &rule = rules.of(slave[i]);
          for (unsigned int q = 0; q < rule.size(); ++q)
            points.push_back(
              {i, rule.point(q), rule.weight(q) * slave[i].jacobian(rule.point(q)), {}});
        }
      return points;
    }

    /// Pair given integration points with the closest points of the master that face them. The
    /// radius is that of the largest face of all ranks, so that all of them take part in the same
    /// search. Points without a projection are dropped. Collective.
    template <int dim>
    std::vector<PairedPoint<dim>>
    pair_by_projection(const SlaveSide<dim>                          &slave,
                       const std::vector<FixedIntegrationPoint<dim>> &fixed_points,
                       const MasterFaces<dim>                        &master,
                       const double                                   limit,
                       const MPI_Comm                                 comm,
                       SearchStatistics                              &statistics)
    {
      std::vector<Point<dim>>              positions;
      std::vector<Tensor<1, dim>>          normals;
      std::vector<PreviousMasterFace<dim>> former;
      std::vector<ReferencePoint<dim>>     rest;
      double                               largest = 0;
      for (const FacePatch<dim> &face : slave.patches)
        largest = std::max(largest, search_radius(face, limit));
      for (const FixedIntegrationPoint<dim> &point : fixed_points)
        {
          positions.push_back(slave.patches[point.face].position(point.xi));
          normals.push_back(slave.patches[point.face].normal(point.xi));
          former.push_back(point.former);
          if (slave.rest)
            rest.push_back(reference_point((*slave.rest)[point.face], point.xi));
        }
      auto master_points = find_master_projections(positions,
                                                   normals,
                                                   master,
                                                   Utilities::MPI::max(largest, comm),
                                                   comm,
                                                   &statistics,
                                                   former,
                                                   rest);

      std::vector<PairedPoint<dim>> points;
      for (std::size_t i = 0; i < fixed_points.size(); ++i)
        if (master_points[i])
          points.push_back({fixed_points[i].face,
                            fixed_points[i].xi,
                            fixed_points[i].weight,
                            std::move(*master_points[i])});
      return points;
    }

    /// Points of segments that lie beside the face of their segment get the closest point of the
    /// whole master surface instead, if that is on another face and closer: otherwise the edge of
    /// the first face would be the projection of many points. On a self-contact surface only points
    /// within four faces of their projection are moved, since any other part of the surface would
    /// be in the range. Collective; returns on all ranks at once if no rank has such points.
    template <int dim>
    void
    move_to_closest(const SlaveSide<dim>          &slave,
                    const MasterFaces<dim>        &master,
                    const MPI_Comm                 comm,
                    SearchStatistics              &statistics,
                    std::vector<PairedPoint<dim>> &points)
    {
      // Over an edge, two faces are equally close up to rounding.
      constexpr double closer = 1 - 1e-6;
      // In face diameters; on a self-contact surface all of it is within the range of the search.
      constexpr double                 far = 4;
      std::vector<PairedPoint<dim> *>  beside_faces;
      std::vector<Point<dim>>          positions;
      std::vector<Tensor<1, dim>>      normals;
      std::vector<ReferencePoint<dim>> rest;
      double                           farthest = 0;
      for (PairedPoint<dim> &point : points)
        if (point.is_beside && (!slave.rest || point.master_point.distance <
                                                 far * slave.patches[point.face].diameter()))
          {
            beside_faces.push_back(&point);
            positions.push_back(slave.patches[point.face].position(point.xi));
            normals.push_back(slave.patches[point.face].normal(point.xi));
            farthest = std::max(farthest, point.master_point.distance);
            if (slave.rest)
              rest.push_back(reference_point((*slave.rest)[point.face], point.xi));
          }
      farthest = Utilities::MPI::max(farthest, comm);
      if (farthest == 0)
        return;
      auto master_points =
        find_master_projections(positions, normals, master, farthest, comm, &statistics, {}, rest);
      for (std::size_t i = 0; i < master_points.size(); ++i)
        if (master_points[i] &&
            master_points[i]->distance < closer * beside_faces[i]->master_point.distance)
          beside_faces[i]->master_point = std::move(*master_points[i]);
    }

    /// Stable sort of points by slave faces. The order is found by sorting numbers, and each point
    /// is then moved once, since points are large.
    template <int dim>
    std::vector<PairedPoint<dim>>
    sorted_by_faces(std::vector<PairedPoint<dim>> &&points)
    {
      std::vector<unsigned int> order(points.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return points[a].face < points[b].face;
      });
      std::vector<PairedPoint<dim>> sorted;
      sorted.reserve(points.size());
      for (const unsigned int i : order)
        sorted.push_back(std::move(points[i]));
      return sorted;
    }

    /// The areas of the faces [length^(dim-1)], integrated with two Gauss points more than the
    /// largest degree of the geometry in each direction.
    template <int dim>
    std::vector<double>
    areas_of(const std::vector<FacePatch<dim>> &faces)
    {
      unsigned int degree = 1;
      for (const FacePatch<dim> &face : faces)
        degree = std::max(degree, face.get_degree());
      std::vector<double> areas;
      for (const FacePatch<dim> &face : faces)
        {
          const Quadrature<dim - 1> &rule = cell_rule<dim - 1>(face.reference_cell(), degree + 2);
          areas.push_back(0);
          for (unsigned int q = 0; q < rule.size(); ++q)
            areas.back() += rule.weight(q) * face.jacobian(rule.point(q));
        }
      return areas;
    }

    /// Numbers of the faces whose points have a total weight of more than the area of the face:
    /// several layers of master faces lie within the limit.
    template <int dim>
    std::vector<unsigned int>
    covered_twice(const std::vector<double> &areas, const std::vector<PairedPoint<dim>> &points)
    {
      // Weights are areas on the slave, so that their sum is the area that master faces cover, with
      // multiplicity.
      std::vector<double> covered(areas.size(), 0.);
      for (const PairedPoint<dim> &point : points)
        covered[point.face] += point.weight;
      std::vector<unsigned int> faces;
      for (unsigned int i = 0; i < areas.size(); ++i)
        if (covered[i] > covered_once * areas[i])
          faces.push_back(i);
      return faces;
    }

    /// Remove the points of some faces that are farther from the master than a distance.
    /// @param most largest distance by face [length]
    template <int dim>
    void
    remove_points(const std::vector<unsigned int> &faces,
                  const std::vector<double>       &most,
                  std::vector<PairedPoint<dim>>   &points)
    {
      std::vector<bool> is_one(most.size(), false);
      for (const unsigned int face : faces)
        is_one[face] = true;
      points.erase(std::remove_if(points.begin(),
                                  points.end(),
                                  [&](const auto &point) {
                                    return is_one[point.face] &&
                                           point.master_point.distance > most[point.face];
                                  }),
                   points.end());
    }

    /// Resolve faces that segments cover more than once (doc/theory, 3.3). First the points that
    /// are farther away by a face size than the nearest point of the face are removed, which belong
    /// to a layer behind the first one; if the face is still covered more than once, all of its
    /// points are.
    /// @return numbers of the latter faces, which are to be paired by projection
    template <int dim>
    std::vector<unsigned int>
    remove_overcovered(const std::vector<FacePatch<dim>> &slave,
                       std::vector<PairedPoint<dim>>     &points)
    {
      // Areas and weights are both those of the current configuration.
      const std::vector<double> areas = areas_of(slave);
      std::vector<unsigned int> faces = covered_twice(areas, points);
      if (faces.empty())
        return faces;
      std::vector<double> most(slave.size(), std::numeric_limits<double>::max());
      for (const PairedPoint<dim> &point : points)
        most[point.face] = std::min(most[point.face], point.master_point.distance);
      for (const unsigned int face : faces)
        most[face] += slave[face].diameter();
      remove_points(faces, most, points);
      faces = covered_twice(areas, points);
      remove_points(faces, std::vector<double>(slave.size(), -1.), points);
      return faces;
    }
  } // namespace



  // Gauss-Lobatto points are the nodes of a face; other rules use Gauss points. On triangles of
  // degree 2 they are the nodes and the middle, with the weights of the rule of degree 3.
  template <int dim>
  FaceRules<dim>::FaceRules(const Integration &integration)
  {
    const unsigned int n = integration.n_points;
    if (integration.rule != Rule::nodes)
      {
        of_hypercubes = cell_rule<dim - 1>(ReferenceCells::get_hypercube<dim - 1>(), n);
        of_triangles  = cell_rule<dim - 1>(ReferenceCells::get_simplex<dim - 1>(), n);
        return;
      }
    of_hypercubes = QGaussLobatto<dim - 1>(n);
    if constexpr (dim == 3)
      {
        std::vector<Point<2>> points = face_lattice<3>(ReferenceCells::Triangle, n - 1);
        std::vector<double>   weights(points.size(), 1. / 6);
        if (n > 2)
          {
            weights = {{1. / 40, 1. / 15, 1. / 40, 1. / 15, 1. / 15, 1. / 40}};
            points.push_back(ReferenceCells::Triangle.barycenter<2>());
            weights.push_back(9. / 40);
          }
        of_triangles = {points, weights};
      }
  }



  // Pair the points of the slave faces with the master (doc/theory, 3.1, 3.3): by segments where
  // these cover a face once, else by projection of quadrature points; then spurious penetrations
  // and faces beyond the limit are removed. All searches are collective, so that each rank takes
  // part in them even without faces. Cost: a few exchanges, and work proportional to the faces
  // within the limit.
  template <int dim>
  Pairing<dim>
  pair_points(const SlaveSide<dim>   &slave,
              const MasterFaces<dim> &master,
              const Integration      &integration,
              const double            limit,
              const MPI_Comm          comm,
              SearchStatistics       &statistics)
  {
    Pairing<dim>              pairing;
    auto                     &points = pairing.points;
    const FaceRules<dim>      rules(integration);
    std::vector<unsigned int> faces(slave.patches.size());
    std::iota(faces.begin(), faces.end(), 0);
    // Segments first; their result leaves in `faces` only those to be paired by projection of Gauss
    // points.
    if (integration.rule == Rule::segments)
      {
        pairing = pair_by_segments(slave, master, integration, limit, comm, statistics);
        faces   = remove_overcovered(slave.patches, points);
        move_to_closest(slave, master, comm, statistics, points);
      }
    if (Utilities::MPI::max(faces.size(), comm) > 0)
      for (auto &point : pair_by_projection(slave,
                                            make_integration_point(slave.patches, faces, rules),
                                            master,
                                            limit,
                                            comm,
                                            statistics))
        points.push_back(std::move(point));
    if (!slave.rest) // On self-contact surfaces, cannot_self_contact() has excluded points beyond
                     // the body itself already.
      drop_spurious_penetrations(slave.patches, master, comm, statistics, points);
    keep_near_faces(slave.patches, limit, points);
    points = sorted_by_faces(std::move(points));
    // Faces without points, and those that are not paired by segments, have no segment edges.
    std::vector<bool> has_segments(slave.patches.size(), true);
    for (const unsigned int face : faces)
      has_segments[face] = false;
    auto &edge_points = pairing.edge_points;
    edge_points.erase(std::remove_if(edge_points.begin(),
                                     edge_points.end(),
                                     [&](const auto &edge_point) {
                                       return !has_segments[edge_point.face];
                                     }),
                      edge_points.end());
    edge_points = sorted_by_faces(std::move(edge_points));
    return pairing;
  }



  // The integration points are those of an earlier search, so that only the projections change.
  // Collective.
  template <int dim>
  std::vector<PairedPoint<dim>>
  reproject_points(const SlaveSide<dim>                          &slave,
                   const std::vector<FixedIntegrationPoint<dim>> &fixed_points,
                   const MasterFaces<dim>                        &master,
                   const double                                   limit,
                   const MPI_Comm                                 comm,
                   SearchStatistics                              &statistics)
  {
    auto points = pair_by_projection(slave, fixed_points, master, limit, comm, statistics);
    keep_near_faces(slave.patches, limit, points);
    return points;
  }



  template <int dim>
  void
  keep_near_faces(const std::vector<FacePatch<dim>> &slave,
                  const double                       limit,
                  std::vector<PairedPoint<dim>>     &points)
  {
    // A face is kept or dropped as a whole: with points on a part of a face only, its pressure
    // functions would be cut off at the search radius.
    std::vector<bool> is_near(slave.size(), false);
    for (const PairedPoint<dim> &point : points)
      {
        const MasterProjection<dim> &master_point = point.master_point;
        if (!is_near[point.face])
          is_near[point.face] =
            master_point.distance <= limit ||
            (slave[point.face].position(point.xi) - master_point.position) * master_point.normal <
              0;
      }
    points.erase(std::remove_if(points.begin(),
                                points.end(),
                                [&](const auto &point) { return !is_near[point.face]; }),
                 points.end());
  }



  template std::vector<PairedPoint<2>>
  reproject_points(const SlaveSide<2> &,
                   const std::vector<FixedIntegrationPoint<2>> &,
                   const MasterFaces<2> &,
                   double,
                   MPI_Comm,
                   SearchStatistics &);
  template std::vector<PairedPoint<3>>
  reproject_points(const SlaveSide<3> &,
                   const std::vector<FixedIntegrationPoint<3>> &,
                   const MasterFaces<3> &,
                   double,
                   MPI_Comm,
                   SearchStatistics &);
  template void
  keep_near_faces(const std::vector<FacePatch<2>> &, double, std::vector<PairedPoint<2>> &);
  template void
  keep_near_faces(const std::vector<FacePatch<3>> &, double, std::vector<PairedPoint<3>> &);
  template struct FaceRules<2>;
  template struct FaceRules<3>;
  template Pairing<2>
  pair_points<2>(const SlaveSide<2> &,
                 const MasterFaces<2> &,
                 const Integration &,
                 double,
                 MPI_Comm,
                 SearchStatistics &);
  template Pairing<3>
  pair_points<3>(const SlaveSide<3> &,
                 const MasterFaces<3> &,
                 const Integration &,
                 double,
                 MPI_Comm,
                 SearchStatistics &);
} // namespace Signorini
