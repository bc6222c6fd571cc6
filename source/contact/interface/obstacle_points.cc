// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/gap_second_variation.h"
#include "contact/constraints/trace.h"
#include "contact/interface/surface_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The row n . u of an obstacle at x over its rigid-body degrees of freedom; empty if it is
    /// fixed.
    template <int dim>
    SparseRow
    rigid_row(const RigidPose<dim>         &pose,
              const types::global_dof_index first,
              const Point<dim>             &x,
              const Tensor<1, dim>         &n)
    {
      SparseRow row;
      if (first == numbers::invalid_dof_index)
        return row;
      const auto values = pose.row(x, n);
      for (unsigned int i = 0; i < values.size(); ++i)
        if (values[i] != 0)
          row.emplace_back(first + i, values[i]);
      return row;
    }
  } // namespace



  // The projections of the points of whole slave faces onto an obstacle. Every rank knows all
  // obstacles, so that nothing is exchanged.
  template <int dim>
  std::vector<PairedPoint<dim>>
  obstacle_points(const Configuration<dim> &configuration,
                  const BoundaryFaces<dim> &slave,
                  const Obstacle<dim>      &obstacle,
                  const Integration        &integration,
                  const double              limit,
                  const bool                with_motion)
  {
    const auto           first = configuration.elasticity().first_dof(obstacle.name);
    const RigidPose<dim> pose  = configuration.pose(obstacle);
    const RigidPose<dim> pose_at_start =
      configuration.start() ? configuration.start()->pose(obstacle) : pose;
    const FaceRules<dim>          rules(integration);
    std::vector<PairedPoint<dim>> points;
    for (unsigned int i = 0; i < slave.patches.size(); ++i)
      {
        const FacePatch<dim>      &face = slave.patches[i];
        const Quadrature<dim - 1> &rule = rules.of(face);
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const Point<dim - 1> &xi = rule.point(q);
            const auto &[point_on_obstacle, place] =
              configuration.partner(obstacle, pose, face, slave.rest[i], xi);
            // A point takes part if it is near enough and faces the obstacle.
            if (std::abs(point_on_obstacle.gap) > search_radius(face, limit) ||
                !faces_each_other(face.normal(xi), point_on_obstacle.normal))
              continue;
            PairedPoint<dim> point{i, xi, rule.weight(q) * face.jacobian(xi), {}};
            point.master_point.position = place;
            point.master_point.normal   = point_on_obstacle.normal;
            point.master_point.distance = std::abs(point_on_obstacle.gap);
            // An obstacle is rigid: infinite stiffness in series, infinite bound of the stress, so
            // that the slave alone determines both.
            point.master_point.stiffness = std::numeric_limits<double>::infinity();
            point.master_point.bound     = std::numeric_limits<double>::infinity();
            point.master_point.rigid =
              rigid_row(pose, first, point.master_point.position, point_on_obstacle.normal);
            if (with_motion)
              {
                const Point<dim> &y      = point.master_point.position;
                point.master_point.start = pose_at_start.position(pose.to_body(y));
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    Tensor<1, dim> unit;
                    unit[d]                            = 1;
                    point.master_point.rigid_motion[d] = rigid_row(pose, first, y, unit);
                  }
              }
            if (!configuration.is_reference())
              point.master_point.second_variation =
                second_variation_of_obstacle(point_on_obstacle, pose, face.position(xi), first);
            points.push_back(std::move(point));
          }
      }
    keep_near_faces(slave.patches, limit, points);
    return points;
  }



  template std::vector<PairedPoint<2>>
  obstacle_points(const Configuration<2> &,
                  const BoundaryFaces<2> &,
                  const Obstacle<2> &,
                  const Integration &,
                  double,
                  bool);
  template std::vector<PairedPoint<3>>
  obstacle_points(const Configuration<3> &,
                  const BoundaryFaces<3> &,
                  const Obstacle<3> &,
                  const Integration &,
                  double,
                  bool);
} // namespace Signorini
