// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"
#include <signorini/parameters/section.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A surface that is given by a formula for the gap. In the reference configuration the gap is
    /// measured along the fixed normal; in displaced configurations the surface is where the
    /// formula is zero, and the gap is the distance from it.
    template <int dim>
    class GapFunction : public ObstacleShape<dim>
    {
    public:
      GapFunction()
      {
        normal[dim - 1] = -1;
      }

      void
      declare(Section &section) override
      {
        section.add_noted("Normal",
                          normal,
                          "direction in which the gap opens, out of the obstacle; any length");
        section.add("Gap", gap, "formula in x,y,z of the slave point, and t [length]");
        if (normal.norm() == 0)
          section.fail("Normal", "must not be zero");
      }

      bool
      depends_on_time() const override
      {
        return gap.depends_on_time();
      }

      void
      set_time(const double time) override
      {
        t = time;
      }

      ObstaclePoint<dim>
      closest(const Point<dim> &x) const override
      {
        return {gap.value(x, t), normal / normal.norm()};
      }

      /// True if the formula increases by one per unit length along the normal, so that it is
      /// defined beside the undeformed surface as well.
      bool
      has_closest_point(const Point<dim> &x, const double length) const override
      {
        return std::abs(gradient(x, length) * normal / normal.norm() - 1) < 1e-3;
      }

      /// The closest point on the surface where the formula is zero.
      ObstaclePoint<dim>
      closest_point(const Point<dim> &x, const double length) const override
      {
        // Iteration: move to the tangent plane at the last point, and back to the surface along the
        // gradient. It converges by a factor of gap times curvature in each step; where that is
        // more than one, the steps are shortened. At most 100 steps.
        Point<dim>       foot  = x;
        Tensor<1, dim>   n     = normal / normal.norm();
        constexpr double small = 1e-13, epsilon = std::numeric_limits<double>::epsilon();
        const double     least = std::max(small * length, 2 * epsilon * x.norm());
        double           share = 1, last = std::numeric_limits<double>::max(), distance = 0;
        for (unsigned int i = 0; i < 100 && last > least; ++i)
          {
            const Tensor<1, dim> slope = gradient(foot, length);
            n                          = slope / slope.norm();
            const Tensor<1, dim> arm   = x - foot;
            const double         above = gap.value(foot, t) / slope.norm();
            const Tensor<1, dim> step  = arm - (arm * n) * n - above * n;
            // The distance is computed from the arm and the value of the formula: the closest point
            // itself is rounded, which far from the origin is much more than distances are.
            distance = arm * n + above;
            if (step.norm() > 0.8 * last)
              share = std::max(share / 2, 1e-3);
            last = step.norm();
            foot += share * step;
          }
        const double value = gap.value(x, t);
        // Without convergence, or on the wrong side (far from a strongly curved surface), the
        // first-order distance value/slope is used, which has the right sign.
        constexpr double rough = 1e-6;
        if (!(last <= rough * length) ||
            (distance * value < 0 && std::abs(distance) > rough * length))
          {
            const Tensor<1, dim> slope = gradient(x, length);
            return {value / slope.norm(), slope / slope.norm()};
          }
        const Tensor<2, dim> of_foot = curvature(foot, length);
        // Principal curvatures k of the surface become k/(1 + k distance) at x (doc/theory, 5.5).
        const Tensor<2, dim> stretch = unit_symmetric_tensor<dim>() + distance * of_foot;
        return {distance, n, invert(stretch) * of_foot};
      }

    private:
      /// Two points at a step forth and back along a coordinate, with their exact distance:
      /// coordinates are rounded, which far from the origin is much of a step.
      struct Step
      {
        Step(const Point<dim> &x, const unsigned int d, const double h)
          : forth(x)
          , back(x)
        {
          forth[d] += h;
          back[d] -= h;
          length = forth[d] - back[d];
        }

        Point<dim> forth, back;
        double     length;
      };

      /// The gradient of the formula by central differences.
      Tensor<1, dim>
      gradient(const Point<dim> &x, const double length) const
      {
        Tensor<1, dim> result;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const Step step(x, d, 1e-5 * length);
            result[d] = (gap.value(step.forth, t) - gap.value(step.back, t)) / step.length;
          }
        return result;
      }

      /// The curvature tensor of the surface, the derivative of the unit normal along it, by
      /// central differences, symmetrised.
      Tensor<2, dim>
      curvature(const Point<dim> &x, const double length) const
      {
        Tensor<2, dim> change, across;
        const auto     normal_at = [&](const Point<dim> &y) {
          const Tensor<1, dim> slope = gradient(y, length);
          return slope / slope.norm();
        };
        for (unsigned int d = 0; d < dim; ++d)
          {
            const Step step(x, d, 1e-4 * length);
            change[d]    = (normal_at(step.forth) - normal_at(step.back)) / step.length;
            across[d][d] = 1;
          }
        const Tensor<1, dim> n = normal_at(x);
        across -= outer_product(n, n);
        return across * (change + transpose(change)) / 2 * across;
      }

      Point<dim>      normal;
      Expression<dim> gap;
      double          t = 0;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_gap_function()
  {
    return std::make_unique<GapFunction<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_gap_function();
  template std::unique_ptr<ObstacleShape<3>>
  make_gap_function();
} // namespace Signorini
