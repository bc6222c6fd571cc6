// SPDX-License-Identifier: Apache-2.0
#include "contact/search/deep_penetration.h"

#include "contact/search/search.h"

#include <algorithm>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The bounding box of the body that a boundary ("body.boundary") belongs to.
    template <int dim>
    const BoundingBox<dim> &
    extent_of_body(const Mesh<dim> &mesh, const std::string &boundary)
    {
      for (unsigned int body = 0; body < mesh.n_bodies(); ++body)
        if (boundary.compare(0, mesh.body_name(body).size() + 1, mesh.body_name(body) + ".") == 0)
          return mesh.extent(body);
      return mesh.extent();
    }

    /// The intersection of two boxes; nothing if it is empty.
    template <int dim>
    std::optional<BoundingBox<dim>>
    common(const BoundingBox<dim> &a, const BoundingBox<dim> &b)
    {
      Point<dim> low, high;
      for (unsigned int d = 0; d < dim; ++d)
        {
          low[d]  = std::max(a.lower_bound(d), b.lower_bound(d));
          high[d] = std::min(a.upper_bound(d), b.upper_bound(d));
          if (low[d] >= high[d])
            return {};
        }
      return BoundingBox<dim>({low, high});
    }

    /// The largest depth of the middles of slave faces inside of an obstacle, of those that face
    /// the obstacle's surface [length]. Local.
    template <int dim>
    double
    depth_in_obstacle(const std::vector<FacePatch<dim>> &slave, const ObstacleShape<dim> &shape)
    {
      double deepest = 0;
      for (const FacePatch<dim> &patch : slave)
        {
          const ObstaclePoint<dim> point_on_obstacle =
            shape.closest(patch.position(patch.middle()));
          if (faces_each_other(patch.normal(patch.middle()), point_on_obstacle.normal))
            deepest = std::max(deepest, -point_on_obstacle.gap);
        }
      return deepest;
    }

    /// The largest depth of the slave faces whose middles lie in the box [length], the intersection
    /// of the boxes of both bodies, in which alone they can penetrate each other. A middle counts
    /// if it has a projection onto the master that faces it and is inside of the master by the
    /// closest point of any orientation: on the far side of a thin body a point may face the master
    /// although it is outside of it. Collective.
    template <int dim>
    double
    depth_in_body(const std::vector<FacePatch<dim>> &slave,
                  const std::vector<FacePatch<dim>> &master,
                  const BoundingBox<dim>            &box,
                  const MPI_Comm                     comm)
    {
      std::vector<Point<dim>>     centers;
      std::vector<Tensor<1, dim>> normals;
      for (const FacePatch<dim> &patch : slave)
        // The diagonal of the box bounds each distance inside of it, so that no projection is
        // missed.
        if (const Point<dim> x = patch.position(patch.middle()); box.point_inside(x))
          {
            centers.push_back(x);
            normals.push_back(patch.normal(patch.middle()));
          }
      const MasterFaces<dim> faces{master, [](auto, const auto &, auto &) {}};
      const double           diagonal =
        box.get_boundary_points().first.distance(box.get_boundary_points().second);
      const auto master_points = find_master_projections(centers, normals, faces, diagonal, comm);
      const auto depth         = depths(centers, faces, diagonal, comm);
      double     deepest       = 0;
      for (std::size_t i = 0; i < master_points.size(); ++i)
        if (master_points[i] && depth[i] >= 0)
          deepest =
            std::max(deepest, (master_points[i]->position - centers[i]) * master_points[i]->normal);
      return deepest;
    }
  } // namespace



  template <int dim>
  double
  common_depth(const BoundingBox<dim> &a, const BoundingBox<dim> &b)
  {
    const auto box   = common(a, b);
    double     depth = box ? box->side_length(0) : 0.;
    for (unsigned int d = 1; box && d < dim; ++d)
      depth = std::min(depth, box->side_length(d));
    return depth;
  }



  // Overlaps that are prescribed by a formula of the gap are no overlaps of the geometry, a surface
  // overlaps with itself always, and the image of a body is not the body.
  template <int dim>
  bool
  may_overlap(const Mesh<dim> &mesh, const ContactPair<dim> &pair)
  {
    return !pair.gap_is_given() && !pair.is_self() && pair.master_is_in_place() &&
           common_depth(extent_of_body(mesh, pair.slave), extent_of_body(mesh, pair.master)) > 0;
  }



  // A lower bound by the middles of the faces. It is needed only where the search radius would be
  // too small to find the penetrating points at all. Collective.
  template <int dim>
  double
  penetration_beyond(const double              distance,
                     const Elasticity<dim>    &elasticity,
                     const ContactPair<dim>   &pair,
                     const Obstacle<dim>      *obstacle,
                     const BoundaryFaces<dim> &slave)
  {
    if (pair.gap_is_given() || pair.is_self() || !pair.master_is_in_place())
      return 0;
    const Mesh<dim> &mesh    = elasticity.mesh();
    const MPI_Comm   comm    = mesh.communicator();
    double           deepest = 0;
    if (obstacle)
      deepest = depth_in_obstacle(slave.patches, *obstacle->shape);
    else
      {
        // Bodies whose boxes overlap by less than the distance cannot penetrate each other deeper,
        // and are not searched.
        const auto &a = extent_of_body(mesh, pair.slave), &b = extent_of_body(mesh, pair.master);
        if (common_depth(a, b) > distance)
          deepest = depth_in_body(slave.patches,
                                  BoundaryFaces<dim>(elasticity, pair.master).patches,
                                  *common(a, b),
                                  comm);
      }
    deepest = Utilities::MPI::max(deepest, comm);
    return deepest > distance ? deepest : 0.;
  }



  template double
  common_depth(const BoundingBox<2> &, const BoundingBox<2> &);
  template double
  common_depth(const BoundingBox<3> &, const BoundingBox<3> &);
  template bool
  may_overlap(const Mesh<2> &, const ContactPair<2> &);
  template bool
  may_overlap(const Mesh<3> &, const ContactPair<3> &);
  template double
  penetration_beyond(double,
                     const Elasticity<2> &,
                     const ContactPair<2> &,
                     const Obstacle<2> *,
                     const BoundaryFaces<2> &);
  template double
  penetration_beyond(double,
                     const Elasticity<3> &,
                     const ContactPair<3> &,
                     const Obstacle<3> *,
                     const BoundaryFaces<3> &);
} // namespace Signorini
