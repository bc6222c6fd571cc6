// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shape_parameter.h"
#include "contact/obstacles/shapes.h"

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A circular cone (2D: wedge).
    template <int dim>
    class Cone : public ObstacleShape<dim>
    {
    public:
      Cone()
      {
        normal[dim - 1] = -1;
      }

      void
      declare(Section &section) override
      {
        section.add("Apex", apex, "[length]");
        section.add_noted("Normal",
                          normal,
                          "axis, out of the obstacle at the apex, towards the body; any length");
        angle.declare(
          section,
          "Angle",
          "between the flank and the plane normal to the axis: number, or formula in t where there is no friction [degrees]",
          Range{0, 89, false});
        if (normal.norm() == 0)
          section.fail("Normal", "must not be zero");
      }

      bool
      depends_on_time() const override
      {
        return angle.depends_on_time();
      }

      void
      set_time(const double t) override
      {
        angle.set_time(t);
      }

      ObstaclePoint<dim>
      closest(const Point<dim> &x) const override
      {
        // Coordinates height along the axis and s across it. The flank is height = -s tan(angle),
        // with the outward normal (cosine, sine); the distance from it is the product with that
        // normal.
        const Tensor<1, dim> n      = normal / normal.norm();
        const Tensor<1, dim> r      = x - apex;
        const double         height = r * n;
        const Tensor<1, dim> across = r - height * n;
        const double         s      = across.norm();
        const double         sine   = std::sin(angle * numbers::PI / 180),
                     cosine         = std::cos(angle * numbers::PI / 180);
        if (s <= 1e-10 * r.norm() && height <= 0)
          return {height, n}; // no flank is closer than the others
        if (height * sine > s * cosine)
          return {r.norm(), r / r.norm()}; // the apex is closest
        Tensor<2, dim> curvature;          // around the axis alone
        if constexpr (dim == 3)
          {
            const Tensor<1, dim> around = cross_product_3d(n, across / s);
            // A cone is straight along its flank; around the axis the curvature at x is sine over
            // the distance from the axis.
            curvature = sine / s * outer_product(around, around);
          }
        return {height * cosine + s * sine, cosine * n + sine / s * across, curvature};
      }

    private:
      Point<dim>     apex, normal;
      ShapeParameter angle{10};
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_cone()
  {
    return std::make_unique<Cone<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_cone();
  template std::unique_ptr<ObstacleShape<3>>
  make_cone();
} // namespace Signorini
