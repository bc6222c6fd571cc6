#include "contact/search/sweep.h"

#include "contact/search/boundary_faces.h"
#include "contact/search/reach.h"
#include "contact/search/search.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A place on the surface, and how thick its cell is.
    template <int dim>
    struct Place
    {
      Point<dim>     x, at_rest;
      Tensor<1, dim> normal;
      double         depth;
      unsigned int   face; ///< number on this rank
    };

    template <int dim>
    bool
    is_in(const Place<dim> &place, const ObstaclePlace<dim> &closest)
    {
      constexpr double small = 1e-3;
      return closest.gap < -small * place.depth;
    }

    template <int dim>
    bool
    is_behind(const Place<dim> &place, const ObstaclePlace<dim> &closest)
    {
      constexpr double alike = 0.1;
      return is_in(place, closest) && place.normal * closest.normal > alike;
    }

    template <int dim>
    bool
    sees(const Place<dim> &place, const ObstaclePlace<dim> &closest)
    {
      return faces_each_other(place.normal, closest.normal);
    }

    template <int dim>
    std::vector<Place<dim>>
    places_of(const Configuration<dim> &now, const std::string &surface)
    {
      const QGauss<dim - 1>    inner(2);
      std::vector<Place<dim>>  result;
      const BoundaryFaces<dim> faces(now, surface);
      for (unsigned int i = 0; i < faces.faces.size(); ++i)
        for (const Point<dim - 1> &xi : inner.get_points())
          result.push_back({faces.patches[i].position(xi),
                            faces.rest[i].position(xi),
                            faces.patches[i].normal(xi),
                            faces.depth(i),
                            i});
      return result;
    }

    /// Those that it may come to, and that are not in it already and see nothing of it.
    template <int dim>
    std::vector<Place<dim>>
    reachable(const Configuration<dim> &from,
              const std::string        &surface,
              const Obstacle<dim>      &obstacle,
              const double              way)
    {
      const RigidPose<dim>    pose = from.pose(obstacle);
      std::vector<Place<dim>> result;
      for (const Place<dim> &place : places_of(from, surface))
        {
          const ObstaclePlace<dim> closest = from.closest(obstacle, pose, place.x);
          if (closest.gap <= way && (!is_in(place, closest) || sees(place, closest)))
            result.push_back(place);
        }
      return result;
    }
  } // namespace



  template <int dim>
  bool
  goes_through(const Configuration<dim> &from,
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
    const std::vector<Place<dim>> places = reachable(from, surface, obstacle, way);
    double                        thin   = std::numeric_limits<double>::max();
    for (const Place<dim> &place : places)
      thin = std::min(thin, place.depth);
    thin                            = Utilities::MPI::min(thin, comm);
    const std::vector<double> first = elasticity.rigid_motion(from.displacement()),
                              last  = elasticity.rigid_motion(to);
    // Nothing is met on a way that is shorter than what is left to the nearest place.
    for (double gone = 0;;)
      {
        std::vector<double> between = first;
        for (unsigned int i = 0; i < between.size(); ++i)
          between[i] += gone / way * (last[i] - first[i]);
        const RigidPose<dim> pose = from.pose(obstacle, between);
        double               free = way;
        // Places that are behind the obstacle; in it; and those of these that see its surface.
        std::vector<unsigned int> n(3, 0);
        for (const Place<dim> &place : places)
          {
            const ObstaclePlace<dim> closest = from.closest(obstacle, pose, place.x);
            n[0] += is_behind(place, closest);
            n[1] += is_in(place, closest);
            n[2] += is_in(place, closest) && sees(place, closest);
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



  template <int dim>
  bool
  is_within(const Configuration<dim> &now,
            const std::string        &surface,
            const Obstacle<dim>      &obstacle,
            const std::vector<bool>  &is_seen)
  {
    constexpr double              much = 0.2;
    const Configuration<dim>      at_rest(now.elasticity());
    const RigidPose<dim>          pose = now.pose(obstacle), first = at_rest.pose(obstacle);
    const std::vector<Place<dim>> places = places_of(now, surface);
    const bool any = std::any_of(places.begin(), places.end(), [&](const Place<dim> &place) {
      return (is_seen.empty() || !is_seen[place.face]) &&
             now.closest(obstacle, pose, place.x).gap < -much * place.depth &&
             (is_seen.empty() || at_rest.closest(obstacle, first, place.at_rest).gap >= 0);
    });
    return Utilities::MPI::max(any ? 1 : 0, now.elasticity().mesh().communicator()) > 0;
  }



  template <int dim>
  bool
  holds(const Configuration<dim> &now, const std::string &surface, const Obstacle<dim> &obstacle)
  {
    constexpr double        inwards = 0.5, much = 0.5;
    const MPI_Comm          comm = now.elasticity().mesh().communicator();
    const RigidPose<dim>    pose = now.pose(obstacle);
    std::vector<Point<dim>> points; // of the obstacle
    std::vector<double>     deep;
    double                  reach = 0;
    for (const Place<dim> &place : places_of(now, surface))
      {
        const ObstaclePlace<dim> closest = now.closest(obstacle, pose, place.x);
        if (closest.gap < much * place.depth || place.normal * closest.normal < inwards)
          continue;
        points.push_back(place.x - closest.gap * closest.normal);
        deep.push_back(much * place.depth);
        reach = std::max(reach, closest.gap);
      }
    reach = Utilities::MPI::max(reach, comm);
    if (reach == 0)
      return false;
    const BoundaryFaces<dim>  faces(now, [&](const CellIterator<dim> &cell, unsigned int) {
      return now.elasticity().mesh().body(cell) == now.elasticity().mesh().body_of(surface);
    });
    const auto                tell  = [](unsigned int, const Point<dim - 1> &, Partner<dim> &) {};
    const std::vector<double> found = depths(points, {faces.patches, tell, {}, {}}, reach, comm);
    unsigned int              n     = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      n += std::isfinite(found[i]) && found[i] > deep[i];
    return Utilities::MPI::sum(n, comm) > 0;
  }



#define INSTANTIATE(dim)                                                                           \
  template bool goes_through(const Configuration<dim> &,                                           \
                             const LA::Vector &,                                                   \
                             const std::string &,                                                  \
                             const Obstacle<dim> &);                                               \
  template bool is_within(const Configuration<dim> &,                                              \
                          const std::string &,                                                     \
                          const Obstacle<dim> &,                                                   \
                          const std::vector<bool> &);                                              \
  template bool holds(const Configuration<dim> &, const std::string &, const Obstacle<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
