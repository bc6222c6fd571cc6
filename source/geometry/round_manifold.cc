// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"

#include <deal.II/base/array_view.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the manifold of deal.II around the origin, spherical if the axis is zero.
    template <int dim>
    std::shared_ptr<const Manifold<dim>>
    manifold_about_origin(const Tensor<1, dim> &axis)
    {
      if constexpr (dim == 3)
        if (axis.norm() > 0)
          return std::make_shared<CylindricalManifold<3>>(axis, Point<3>());
      return std::make_shared<SphericalManifold<dim>>(Point<dim>());
    }
  } // namespace



  template <int dim>
  RoundManifold<dim>::RoundManifold(const Point<dim> &center, const Tensor<1, dim> &axis)
    : center(center)
    , about_origin(manifold_about_origin<dim>(axis))
  {}



  template <int dim>
  std::unique_ptr<Manifold<dim>>
  RoundManifold<dim>::clone() const
  {
    return std::make_unique<RoundManifold<dim>>(*this);
  }



  template <int dim>
  typename RoundManifold<dim>::Scaled
  RoundManifold<dim>::scaled(const Points &points) const
  {
    // Coordinates relative to the centre are divided by a power of two, which is exact: the
    // manifolds of deal.II treat points that are closer than 1e-10 as equal, whatever the unit of
    // length is.
    Scaled result;
    double farthest = 0;
    for (const Point<dim> &x : points)
      {
        result.points.emplace_back(x - center);
        farthest = std::max(farthest, result.points.back().norm());
      }
    result.unit = farthest > 0 ? std::exp2(std::ilogb(farthest)) : 1;
    for (Point<dim> &point : result.points)
      point /= result.unit;
    return result;
  }



  // The inverse of scaled(), for one point.
  template <int dim>
  Point<dim>
  RoundManifold<dim>::in_space(const Point<dim> &point, const double unit) const
  {
    return center + unit * Tensor<1, dim>(point);
  }



  // The following functions scale their points, ask the manifold of deal.II around the origin, and
  // scale the answer back.
  template <int dim>
  Point<dim>
  RoundManifold<dim>::get_intermediate_point(const Point<dim> &p1,
                                             const Point<dim> &p2,
                                             const double      w) const
  {
    const std::array<Point<dim>, 2> both = {{p1, p2}};
    const auto [unit, points]            = scaled(make_array_view(both.begin(), both.end()));
    return in_space(about_origin->get_intermediate_point(points[0], points[1], w), unit);
  }



  template <int dim>
  Point<dim>
  RoundManifold<dim>::get_new_point(const Points                  &surrounding,
                                    const ArrayView<const double> &weights) const
  {
    const auto [unit, points] = scaled(surrounding);
    return in_space(about_origin->get_new_point(make_array_view(points), weights), unit);
  }



  template <int dim>
  void
  RoundManifold<dim>::get_new_points(const Points           &surrounding,
                                     const Table<2, double> &weights,
                                     ArrayView<Point<dim>>   new_points) const
  {
    const auto [unit, points] = scaled(surrounding);
    about_origin->get_new_points(make_array_view(points), weights, new_points);
    for (Point<dim> &point : new_points)
      point = in_space(point, unit);
  }



  // A tangent is a difference of points: it is scaled back, but not moved to the centre.
  template <int dim>
  Tensor<1, dim>
  RoundManifold<dim>::get_tangent_vector(const Point<dim> &x1, const Point<dim> &x2) const
  {
    const std::array<Point<dim>, 2> both = {{x1, x2}};
    const auto [unit, points]            = scaled(make_array_view(both.begin(), both.end()));
    return unit * about_origin->get_tangent_vector(points[0], points[1]);
  }



  template class RoundManifold<2>;
  template class RoundManifold<3>;
} // namespace Signorini
