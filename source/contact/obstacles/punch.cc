// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shape_parameter.h"
#include "contact/obstacles/shapes.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A flat face at the end of a circular shaft (2D: a strip), with an edge rounded by a quarter
    /// of a circle.
    template <int dim>
    class Punch : public ObstacleShape<dim>
    {
    public:
      Punch()
      {
        normal[dim - 1] = -1;
      }

      void
      declare(Section &section) override
      {
        section.add("Center", center, "of the flat face [length]");
        section.add_noted("Normal",
                          normal,
                          "of the flat face, out of the obstacle, towards the body; any length");
        radius.declare(
          section,
          "Radius",
          dim == 2 ?
            "half the width of the flat face: number, or formula in t where there is no friction [length]" :
            "of the flat face: number, or formula in t where there is no friction [length]",
          positive);
        edge.declare(
          section,
          "Edge radius",
          "of the rounded edge; 0: sharp; number, or formula in t where there is no friction [length]",
          non_negative);
        if (normal.norm() == 0)
          section.fail("Normal", "must not be zero");
      }

      bool
      depends_on_time() const override
      {
        return radius.depends_on_time() || edge.depends_on_time();
      }

      void
      set_time(const double t) override
      {
        radius.set_time(t);
        edge.set_time(t);
      }

      ObstaclePoint<dim>
      closest(const Point<dim> &x) const override
      {
        const Tensor<1, dim> n       = normal / normal.norm();
        const Tensor<1, dim> r       = x - center;
        const double         height  = r * n;
        const Tensor<1, dim> lateral = r - height * n;
        const double         beyond  = lateral.norm() - radius;
        if (beyond <= 0)
          return {height, n};
        // The edge is a quarter of a circle (a torus) behind the rim of the flat face.
        const Tensor<1, dim> out = lateral / lateral.norm();
        if (height <= -edge)
          return {beyond - edge, out}; // beside the shaft
        const Tensor<1, dim> from_center = beyond * out + (height + edge) * n;
        const double         distance    = from_center.norm();
        const Tensor<1, dim> to_x        = from_center / distance;
        Tensor<2, dim>       curvature;
        if (edge > 0)
          {
            // The principal curvatures of a torus: across the edge, and around the axis.
            const Tensor<1, dim> across = (out * to_x) * n - (n * to_x) * out;
            curvature                   = outer_product(across, across) / distance;
            if constexpr (dim == 3)
              {
                const Tensor<1, dim> around = cross_product_3d(n, out);
                curvature += (out * to_x) / lateral.norm() * outer_product(around, around);
              }
          }
        return {distance - edge, to_x, curvature};
      }

    private:
      Point<dim>     center, normal;
      ShapeParameter radius{1}, edge{0};
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_punch()
  {
    return std::make_unique<Punch<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_punch();
  template std::unique_ptr<ObstacleShape<3>>
  make_punch();
} // namespace Signorini
