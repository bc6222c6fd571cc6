// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shape_parameter.h"
#include "contact/obstacles/shapes.h"

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A paraboloid of revolution. In the reference configuration the gap is measured along the
    /// axis, as in Hertz' theory; in displaced ones it is the distance.
    template <int dim>
    class Paraboloid : public ObstacleShape<dim>
    {
    public:
      Paraboloid()
      {
        normal[dim - 1] = -1;
      }

      void
      declare(Section &section) override
      {
        section.add("Apex", apex, "vertex of the paraboloid [length]");
        section.add_noted("Normal",
                          normal,
                          "axis at the apex, out of the obstacle, towards the body; any length");
        radius.declare(
          section,
          "Radius",
          "of curvature at the apex: number, or formula in t where there is no friction [length]",
          positive);
        if (normal.norm() == 0)
          section.fail("Normal", "must not be zero");
      }

      bool
      depends_on_time() const override
      {
        return radius.depends_on_time();
      }

      void
      set_time(const double t) override
      {
        radius.set_time(t);
      }

      ObstaclePoint<dim>
      closest(const Point<dim> &x) const override
      {
        const Tensor<1, dim> n = normal / normal.norm();
        const Tensor<1, dim> r = x - apex;
        // Points of the surface have height = - s^2/(2 R) at the distance s from the axis, so that
        // the gap along the axis is the sum of both.
        const double height = r * n;
        return {height + (r.norm_square() - height * height) / (2 * radius), n};
      }

      ObstaclePoint<dim>
      closest_point(const Point<dim> &x, const double /*length*/) const override
      {
        // In the plane through the axis and x, the surface is height = -s^2/(2 R); the closest
        // point is at the radius `foot`.
        const Tensor<1, dim> n      = normal / normal.norm();
        const Tensor<1, dim> r      = x - apex;
        const double         height = r * n;
        const Tensor<1, dim> across = r - height * n;
        const double         s      = across.norm();
        const Tensor<1, dim> out    = s > 0 ? across / s : Tensor<1, dim>();
        const double         foot = closest_radius(s, height), slope = foot / radius,
                     stretch      = std::sqrt(1 + slope * slope);
        const Tensor<1, dim> to_x = (slope * out + n) / stretch;
        const double         gap  = (r - foot * out + foot * slope / 2 * n) * to_x;
        return {gap, to_x, curvature(n, out, slope, gap)};
      }

    private:
      /// The curvatures along the parabola and around the axis, at the distance `gap` from the
      /// surface.
      Tensor<2, dim>
      curvature(const Tensor<1, dim> &n,
                const Tensor<1, dim> &out,
                const double          slope,
                const double          gap) const
      {
        // The curvature k of the surface at its closest point becomes k/(1 + k gap) on the parallel
        // surface through x.
        const auto   at_gap = [gap](const double k) { return k / (1 + k * gap); };
        const double square = 1 + slope * slope, stretch = std::sqrt(square),
                     along = at_gap(1 / (radius * stretch * square));
        if (out.norm() == 0)
          return along * (unit_symmetric_tensor<dim>() - outer_product(n, n));
        const Tensor<1, dim> down   = (out - slope * n) / stretch;
        Tensor<2, dim>       result = along * outer_product(down, down);
        if constexpr (dim == 3)
          {
            const Tensor<1, dim> around = cross_product_3d(n, out);
            result += at_gap(1 / (radius * stretch)) * outer_product(around, around);
          }
        return result;
      }

      /// The radius f of the closest point of the parabola, the solution of f (1 + height/R) +
      /// f^3/(2 R^2) = s, by Newton's method; its left side increases with f outside of the focus,
      /// and inside the largest solution is the closest point.
      double
      closest_radius(const double s, const double height) const
      {
        if (s == 0)
          return 0;
        const double linear = 1 + height / radius;
        double       foot   = std::max(s, radius * std::sqrt(std::max(0., -2 * linear)));
        if (linear > 0)
          foot = std::min(foot, s / linear);
        for (unsigned int i = 0; i < 60; ++i)
          {
            const double square = foot * foot / (radius * radius), slope = linear + 1.5 * square,
                         change = (foot * (linear + square / 2) - s) / slope;
            if (!(slope > 0))
              break;
            foot -= change;
            if (std::abs(change) <= 1e-15 * (std::abs(foot) + s))
              break;
          }
        return foot;
      }

      Point<dim>     apex, normal;
      ShapeParameter radius{1};
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_paraboloid()
  {
    return std::make_unique<Paraboloid<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_paraboloid();
  template std::unique_ptr<ObstacleShape<3>>
  make_paraboloid();
} // namespace Signorini
