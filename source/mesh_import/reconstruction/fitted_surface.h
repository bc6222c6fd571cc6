// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /// A circle, sphere, cylinder or cone on which points lie, r(h) = radius + slope h with the
  /// height h along the axis.
  template <int dim>
  struct FittedSurface
  {
    dealii::Point<dim>     center; ///< of the sphere, or a point of the axis
    dealii::Tensor<1, dim> axis;   ///< unit vector; zero for a circle or sphere
    double                 radius; ///< of a cone: in the plane of the center
    double                 slope;  ///< of a cone: change of the radius along the axis

    /// @return the closest point of the surface; on a cone the one at the same height, which is
    /// close to it if p is close to the surface. NaN if p is the centre or on the axis.
    /// @param p any other point
    dealii::Point<dim>
    closest(const dealii::Point<dim> &p) const;

    /// @return the distance [length] of a point from the surface, on a cone at constant height.
    /// @param p the point
    double
    distance(const dealii::Point<dim> &p) const
    {
      return p.distance(closest(p));
    }

    /// @return a deal.II manifold on which new points of refined cells are placed.
    std::unique_ptr<dealii::Manifold<dim>>
    manifold() const;

    /// @return a text for messages, such as "a cylinder of radius 2 about the axis through (0, 0,
    /// 0) along (0, 0, 1)".
    std::string
    description() const;
  };

  /// Fit a surface by least squares.
  /// @param points that it shall pass
  /// @param normals of facets between the points, with signs such that neighbours agree, for a
  /// first guess of the axis (3D)
  /// @param tolerance largest distance [length] of any point
  /// @return the simplest surface (sphere, cylinder, cone, in this order) that is no farther than
  /// the tolerance from all points; none if there is none
  template <int dim>
  std::optional<FittedSurface<dim>>
  fit_surface(const std::vector<dealii::Point<dim>>     &points,
              const std::vector<dealii::Tensor<1, dim>> &normals,
              double                                     tolerance);
} // namespace Signorini
