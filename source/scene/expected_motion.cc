// SPDX-License-Identifier: Apache-2.0
#include "scene/expected_motion.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the centre and the corners of a box.
    template <int dim>
    std::vector<Point<dim>>
    corners_and_center(const BoundingBox<dim> &extent)
    {
      const auto &[low, high]        = extent.get_boundary_points();
      std::vector<Point<dim>> points = {low + (high - low) / 2};
      for (unsigned int corner = 0; corner < (1u << dim); ++corner)
        {
          points.push_back(low);
          for (unsigned int d = 0; d < dim; ++d)
            if (corner >> d & 1)
              points.back()[d] = high[d];
        }
      return points;
    }

    /// @return the largest prescribed displacement of supports plus that of obstacles at time t,
    /// evaluated at some points.
    template <int dim>
    double
    prescribed_motion(const Scene<dim>              &scene,
                      const std::vector<Point<dim>> &points,
                      const BoundingBox<dim>        &extent,
                      const double                   t)
    {
      double supports = 0, obstacles = 0;
      for (const Support<dim> &support : scene.supports)
        if (support.acts(t))
          for (const Point<dim> &x : points)
            supports = std::max({supports,
                                 support.displacement.value(x, t).norm(),
                                 std::abs(support.normal_displacement.value(x, t))});
      for (const Obstacle<dim> &obstacle : scene.obstacles)
        obstacles =
          std::max(obstacles,
                   obstacle.body.displacement.value({}, t).norm() +
                     obstacle.body.rotation.value({}, t).norm() * obstacle.body.arm(extent));
      return supports + obstacles;
    }

    /// @return the largest thermal strain of any body at time t. Fields that are not finite outside
    /// of their body are skipped.
    template <int dim>
    double
    largest_expansion(const Scene<dim>              &scene,
                      const std::vector<Point<dim>> &points,
                      const double                   t)
    {
      double largest = 0;
      for (const Body<dim> &body : scene.bodies)
        if (body.expansion.given())
          {
            const std::vector<double> &field = body.mesh.generator->temperature();
            std::vector<double>        extremes{0.};
            if (!field.empty())
              extremes = {*std::min_element(field.begin(), field.end()),
                          *std::max_element(field.begin(), field.end())};
            for (const Point<dim> &x : points)
              for (const double T : extremes)
                {
                  const double rise = body.expansion.value(x, t, T) - body.expansion.reference;
                  if (std::isfinite(rise))
                    largest = std::max(largest, std::abs(rise) * body.expansion.alpha().norm());
                }
          }
      return largest;
    }

    /// @return five points in each direction of a box, for formulas that vary inside.
    template <int dim>
    std::vector<Point<dim>>
    lattice(const BoundingBox<dim> &extent)
    {
      constexpr unsigned int  n = 5;
      std::vector<Point<dim>> points;
      for (unsigned int i = 0; i < Utilities::fixed_power<dim>(n); ++i)
        {
          Point<dim> unit;
          for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n)
            unit[d] = double(rest % n) / (n - 1);
          points.push_back(extent.unit_to_real(unit));
        }
      return points;
    }

    /// @return the largest load at time t as a stress: forces are divided by an area of the size of
    /// the model, body forces are multiplied by that size.
    template <int dim>
    double
    largest_load(const Scene<dim>              &scene,
                 const std::vector<Point<dim>> &points,
                 const double                   size,
                 const double                   t)
    {
      double largest = 0;
      for (const Load<dim> &load : scene.loads)
        for (const Point<dim> &x : points)
          largest =
            std::max(largest,
                     load.traction.value(x, t).norm() + std::abs(load.pressure.value(x, t)) +
                       load.body_force.value(x, t).norm() * size +
                       (load.force.value(x, t).norm() + load.total_force.value(x, t).norm() +
                        load.total_moment.value(x, t).norm() / size) /
                         std::pow(size, dim - 1));
      return largest;
    }
  } // namespace



  // The sum of prescribed motion, elastic and thermal deformation, as the maximum over the ends of
  // all load steps.
  template <int dim>
  double
  expected_motion(const Scene<dim> &scene, const BoundingBox<dim> &extent)
  {
    const std::vector<Point<dim>> points = corners_and_center(extent), inside = lattice(extent);
    const auto                   &bounds = extent.get_boundary_points();
    const double                  size   = bounds.first.distance(bounds.second);
    double minimal_penalty_scale = std::numeric_limits<double>::max(), motion = 0;
    for (const Body<dim> &body : scene.bodies)
      for (const Material *material : body.materials())
        minimal_penalty_scale = std::min(minimal_penalty_scale, material->youngs_modulus);
    for (const double t : scene.load_steps.ends())
      motion = std::max(motion,
                        prescribed_motion(scene, points, extent, t) +
                          largest_load(scene, points, size, t) * size / minimal_penalty_scale +
                          largest_expansion(scene, inside, t) * size);
    return motion;
  }



  template double
  expected_motion(const Scene<2> &, const BoundingBox<2> &);
  template double
  expected_motion(const Scene<3> &, const BoundingBox<3> &);
} // namespace Signorini
