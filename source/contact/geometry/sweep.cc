#include <signorini/contact/geometry/boundary_faces.h>
#include <signorini/contact/geometry/reach.h>
#include <signorini/contact/geometry/sweep.h>

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
      Point<dim>     x;
      Tensor<1, dim> normal;
      double         depth;
    };

    template <int dim>
    bool
    is_behind(const Place<dim> &place, const ObstaclePlace<dim> &closest)
    {
      constexpr double small = 1e-3, alike = 0.1;
      return closest.gap < -small * place.depth && place.normal * closest.normal > alike;
    }

    /// Those that it may come to, and that are not behind it already.
    template <int dim>
    std::vector<Place<dim>>
    reachable(const Configuration<dim> &from,
              const std::string        &surface,
              const Obstacle<dim>      &obstacle,
              const double              way)
    {
      const RigidPose<dim>     pose = from.pose(obstacle);
      const QGauss<dim - 1>    inner(2);
      std::vector<Place<dim>>  result;
      const BoundaryFaces<dim> faces(from, surface);
      for (unsigned int i = 0; i < faces.faces.size(); ++i)
        for (const Point<dim - 1> &xi : inner.get_points())
          {
            const FacePatch<dim>    &patch = faces.patches[i];
            const Place<dim>         place{patch.position(xi), patch.normal(xi), faces.depth(i)};
            const ObstaclePlace<dim> closest = from.closest(obstacle, pose, place.x);
            if (closest.gap <= way && !is_behind(place, closest))
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
        bool                 any  = false;
        for (const Place<dim> &place : places)
          {
            const ObstaclePlace<dim> closest = from.closest(obstacle, pose, place.x);
            any                              = any || is_behind(place, closest);
            free                             = std::min(free, closest.gap);
          }
        if (Utilities::MPI::max(any ? 1 : 0, comm) > 0)
          return true;
        if (gone >= way)
          return false;
        gone = std::min(way, gone + std::max(Utilities::MPI::min(free, comm), thin / 2));
      }
  }



#define INSTANTIATE(dim)                                                                           \
  template bool goes_through(const Configuration<dim> &,                                           \
                             const LA::Vector &,                                                   \
                             const std::string &,                                                  \
                             const Obstacle<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
