// SPDX-License-Identifier: Apache-2.0
#include "contact/search/obstacle_path.h"

#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"
#include "contact/search/search_radius.h"
#include "geometry/cell_rule.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A point on the surface of a body: Gauss points of its faces, of which there are 2^(dim-1) on
    /// each.
    template <int dim>
    struct SampledPoint
    {
      /// Position in the configuration considered, and in the reference configuration [length].
      Point<dim> x, at_rest;
      /// Outward unit normal of the surface.
      Tensor<1, dim> normal;
      /// Depth of the cell behind its face [length]: the scale of what counts as penetration.
      double       depth;
      unsigned int face; ///< number on this rank
    };

    /// True if the point is inside of the obstacle by more than a thousandth of its cell.
    template <int dim>
    bool
    is_in(const SampledPoint<dim> &sample, const ObstaclePoint<dim> &closest)
    {
      constexpr double small = 1e-3;
      return closest.gap < -small * sample.depth;
    }

    /// True if the point is inside of the obstacle and its normal has the direction of the
    /// obstacle's: the obstacle has passed the surface and touches it from behind.
    template <int dim>
    bool
    is_behind(const SampledPoint<dim> &sample, const ObstaclePoint<dim> &closest)
    {
      constexpr double alike = 0.1;
      return is_in(sample, closest) && sample.normal * closest.normal > alike;
    }

    /// True if the point faces the closest point of the obstacle, so that the contact search pairs
    /// both.
    template <int dim>
    bool
    has_projection(const SampledPoint<dim> &sample, const ObstaclePoint<dim> &closest)
    {
      return faces_each_other(sample.normal, closest.normal);
    }

    /// The sampled points of the faces of this rank.
    template <int dim>
    std::vector<SampledPoint<dim>>
    places_of(const Configuration<dim> &now, const std::string &surface)
    {
      std::vector<SampledPoint<dim>> result;
      const BoundaryFaces<dim>       faces(now, surface);
      for (unsigned int i = 0; i < faces.faces.size(); ++i)
        for (const Point<dim - 1> &xi :
             cell_rule<dim - 1>(faces.patches[i].reference_cell(), 2).get_points())
          result.push_back({faces.patches[i].position(xi),
                            faces.rest[i].position(xi),
                            faces.patches[i].normal(xi),
                            faces.depth(i),
                            i});
      return result;
    }

    /// The sampled points that the obstacle may reach on its way, a bound of the displacement of
    /// its points [length]. Points are left out that are inside of it at the start and do not face
    /// its surface: they do not become so by the motion.
    template <int dim>
    std::vector<SampledPoint<dim>>
    reachable(const Configuration<dim> &from,
              const std::string        &surface,
              const Obstacle<dim>      &obstacle,
              const double              way)
    {
      const RigidPose<dim>           pose = from.pose(obstacle);
      std::vector<SampledPoint<dim>> result;
      for (const SampledPoint<dim> &sample : places_of(from, surface))
        {
          const ObstaclePoint<dim> closest = from.closest(obstacle, pose, sample.x);
          if (closest.gap <= way && (!is_in(sample, closest) || has_projection(sample, closest)))
            result.push_back(sample);
        }
      return result;
    }
  } // namespace



  // Tunnelling check along the straight path of the rigid motion between two displacements, by
  // sphere tracing: no point of the surface can be met within the smallest gap, so that the path
  // parameter advances by that gap, but by at least half of the thinnest cell, a step in which it
  // cannot pass a wall unnoticed. The number of steps is at most 2 way/thin + 1. The surface is
  // kept at its position before the increment. Collective.
  template <int dim>
  bool
  obstacle_tunnels(const Configuration<dim> &from,
                   const LA::Vector         &to,
                   const std::string        &surface,
                   const Obstacle<dim>      &obstacle)
  {
    const Elasticity<dim> &elasticity = from.elasticity();
    const MPI_Comm         comm       = elasticity.mesh().communicator();
    LA::Vector             change     = to;
    change -= from.displacement();
    const double way = largest_displacement(elasticity, obstacle, change);
    if (way == 0)
      return false;
    const std::vector<SampledPoint<dim>> samples = reachable(from, surface, obstacle, way);
    double                               thin    = std::numeric_limits<double>::max();
    for (const SampledPoint<dim> &sample : samples)
      thin = std::min(thin, sample.depth);
    thin                            = Utilities::MPI::min(thin, comm);
    const std::vector<double> first = elasticity.rigid_motion(from.displacement()),
                              last  = elasticity.rigid_motion(to);
    // `gone` is the length of the path so far, as a bound of the displacement of the obstacle's
    // points; the loop ends at the end of the path.
    for (double gone = 0;;)
      {
        std::vector<double> between = first;
        for (unsigned int i = 0; i < between.size(); ++i)
          between[i] += gone / way * (last[i] - first[i]);
        const RigidPose<dim> pose = from.pose(obstacle, between);
        double               free = way;
        // Numbers of points behind the obstacle; inside of it; and of the latter those that face
        // its surface.
        std::vector<unsigned int> n(3, 0);
        for (const SampledPoint<dim> &sample : samples)
          {
            const ObstaclePoint<dim> closest = from.closest(obstacle, pose, sample.x);
            n[0] += is_behind(sample, closest);
            n[1] += is_in(sample, closest);
            n[2] += is_in(sample, closest) && has_projection(sample, closest);
            free = std::min(free, closest.gap);
          }
        Utilities::MPI::sum(n, comm, n);
        if (n[0] > 0 || (n[1] > 0 && n[2] == 0))
          return true;
        if (gone >= way)
          return false;
        gone = std::min(way, gone + std::max(Utilities::MPI::min(free, comm), thin / 2));
      }
  }



  // The obstacle contains a sampled point by more than a fifth of its cell that no contact pair
  // covers.
  template <int dim>
  bool
  penetrates_obstacle(const Configuration<dim> &now,
                      const std::string        &surface,
                      const Obstacle<dim>      &obstacle,
                      const std::vector<bool>  &is_seen)
  {
    constexpr double                     much = 0.2;
    const Configuration<dim>             at_rest(now.elasticity());
    const RigidPose<dim>                 pose = now.pose(obstacle), first = at_rest.pose(obstacle);
    const std::vector<SampledPoint<dim>> samples = places_of(now, surface);
    // Points that were inside in the reference configuration already, on faces not searched, are
    // not a penetration due to the motion.
    const bool any =
      std::any_of(samples.begin(), samples.end(), [&](const SampledPoint<dim> &sample) {
        return (is_seen.empty() || !is_seen[sample.face]) &&
               now.closest(obstacle, pose, sample.x).gap < -much * sample.depth &&
               (is_seen.empty() || at_rest.closest(obstacle, first, sample.at_rest).gap >= 0);
      });
    return Utilities::MPI::max(any ? 1 : 0, now.elasticity().mesh().communicator()) > 0;
  }



  // For each sampled point with a gap of more than half of its cell, measured along a common
  // direction of the normals (the obstacle is behind the surface), the closest point of the
  // obstacle is checked for being inside of the body.
  template <int dim>
  bool
  encloses_obstacle(const Configuration<dim> &now,
                    const std::string        &surface,
                    const Obstacle<dim>      &obstacle)
  {
    constexpr double        inwards = 0.5, much = 0.5;
    const MPI_Comm          comm = now.elasticity().mesh().communicator();
    const RigidPose<dim>    pose = now.pose(obstacle);
    std::vector<Point<dim>> points; // of the obstacle
    std::vector<double>     deep;
    double                  search_radius = 0;
    for (const SampledPoint<dim> &sample : places_of(now, surface))
      {
        const ObstaclePoint<dim> closest = now.closest(obstacle, pose, sample.x);
        if (closest.gap < much * sample.depth || sample.normal * closest.normal < inwards)
          continue;
        points.push_back(sample.x - closest.gap * closest.normal);
        deep.push_back(much * sample.depth);
        search_radius = std::max(search_radius, closest.gap);
      }
    search_radius = Utilities::MPI::max(search_radius, comm);
    if (search_radius == 0)
      return false;
    // Depths are measured from the surface of the whole body that has the boundary.
    const BoundaryFaces<dim> faces(now, [&](const CellIterator<dim> &cell, unsigned int) {
      return now.elasticity().mesh().body(cell) == now.elasticity().mesh().body_of(surface);
    });
    const auto tell = [](unsigned int, const Point<dim - 1> &, MasterProjection<dim> &) {};
    const std::vector<double> found =
      depths(points, {faces.patches, tell, {}, {}}, search_radius, comm);
    unsigned int n = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      n += std::isfinite(found[i]) && found[i] > deep[i];
    return Utilities::MPI::sum(n, comm) > 0;
  }



#define INSTANTIATE(dim)                                                                           \
  template bool obstacle_tunnels(const Configuration<dim> &,                                       \
                                 const LA::Vector &,                                               \
                                 const std::string &,                                              \
                                 const Obstacle<dim> &);                                           \
  template bool penetrates_obstacle(const Configuration<dim> &,                                    \
                                    const std::string &,                                           \
                                    const Obstacle<dim> &,                                         \
                                    const std::vector<bool> &);                                    \
  template bool encloses_obstacle(const Configuration<dim> &,                                      \
                                  const std::string &,                                             \
                                  const Obstacle<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
