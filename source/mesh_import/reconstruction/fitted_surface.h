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
  /// A circle, sphere, cylinder or cone that points lie on.
  template <int dim>
  struct FittedSurface
  {
    dealii::Point<dim>     center; ///< of the sphere, or a point of the axis
    dealii::Tensor<1, dim> axis;   ///< unit vector; zero for a circle or sphere
    double                 radius; ///< of a cone: in the plane of the center
    double                 slope;  ///< of a cone: change of the radius along the axis

    /// The closest place, of a cone that of the same height.
    dealii::Point<dim>
    closest(const dealii::Point<dim> &p) const;

    double
    distance(const dealii::Point<dim> &p) const
    {
      return p.distance(closest(p));
    }

    std::unique_ptr<dealii::Manifold<dim>>
    manifold() const;

    /// "a cylinder of radius 2 about the axis through (0, 0, 0) along (0, 0, 1)"
    std::string
    description() const;
  };

  /// The simplest such surface that is no farther than that from all points, by least squares.
  /// @param normals of facets between the points, for a first guess of the axis
  template <int dim>
  std::optional<FittedSurface<dim>>
  fit_surface(const std::vector<dealii::Point<dim>>     &points,
              const std::vector<dealii::Tensor<1, dim>> &normals,
              double                                     tolerance);
} // namespace Signorini
