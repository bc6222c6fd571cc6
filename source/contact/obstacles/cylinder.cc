// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shape_parameter.h"
#include "contact/obstacles/shapes.h"

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A circular cylinder, in 2D a circle, or the bore of that shape.
    template <int dim>
    class Cylinder : public ObstacleShape<dim>
    {
    public:
      Cylinder()
      {
        axis[dim - 1] = 1;
      }

      void
      declare(Section &section) override
      {
        section.add("Center", center, "a point of the axis [length]");
        if (dim == 3)
          section.add("Axis", axis, "direction of the axis, any length");
        radius.declare(section,
                       "Radius",
                       "number, or formula in t where there is no friction [length]",
                       positive);
        section.add("Hollow", hollow, "yes: the body is inside, in a bore");
        if (axis.norm() == 0)
          section.fail("Axis", "must not be zero");
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
        // In space only the part across the axis counts.
        Tensor<1, dim> r = x - center;
        if (dim == 3)
          r -= (r * axis) / axis.norm_square() * axis;
        const double distance = r.norm();
        AssertThrow(
          distance > 0,
          ExcMessage(
            "a contact point lies on the axis of a cylindrical obstacle: it has no closest point"));
        const Tensor<1, dim> n         = r / distance;
        Tensor<2, dim>       curvature = unit_symmetric_tensor<dim>() - outer_product(n, n);
        if (dim == 3)
          curvature -= outer_product(axis, axis) / axis.norm_square();
        curvature /= distance;
        // In a bore the body is inside: gap, normal and curvature change their signs.
        return hollow ? ObstaclePoint<dim>{radius - distance, -n, -curvature} :
                        ObstaclePoint<dim>{distance - radius, n, curvature};
      }

    private:
      Point<dim>     center, axis;
      ShapeParameter radius{1};
      bool           hollow = false;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_cylinder()
  {
    return std::make_unique<Cylinder<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_cylinder();
  template std::unique_ptr<ObstacleShape<3>>
  make_cylinder();
} // namespace Signorini
