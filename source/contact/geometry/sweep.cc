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
    is_behind(const Configuration<dim> &from,
              const Obstacle<dim>      &obstacle,
              const RigidPose<dim>     &pose,
              const Place<dim>         &place)
    {
      constexpr double         small = 1e-3, alike = 0.1;
      const ObstaclePlace<dim> closest = from.closest(obstacle, pose, place.x);
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
            const FacePatch<dim> &patch = faces.patches[i];
            const Place<dim>      place{patch.position(xi), patch.normal(xi), faces.depth(i)};
            if (from.closest(obstacle, pose, place.x).gap <= way &&
                !is_behind(from, obstacle, pose, place))
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
    constexpr unsigned int most       = 50;
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
    thin                       = Utilities::MPI::min(thin, comm);
    const unsigned int n_poses = std::clamp(std::ceil(way / thin), 1., double(most));
    bool               any     = false;
    for (unsigned int k = 1; k <= n_poses; ++k)
      {
        LA::Vector between = from.displacement();
        between.add(double(k) / n_poses, change);
        const RigidPose<dim> pose = Configuration<dim>(elasticity, between).pose(obstacle);
        any = any || std::any_of(places.begin(), places.end(), [&](const Place<dim> &place) {
                return is_behind(from, obstacle, pose, place);
              });
      }
    return Utilities::MPI::max(any ? 1 : 0, comm) > 0;
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
