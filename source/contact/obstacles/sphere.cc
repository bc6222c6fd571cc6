// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shape_parameter.h"
#include "contact/obstacles/shapes.h"

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A sphere, in 2D a circle, or a spherical seat.
    template <int dim>
    class Sphere : public ObstacleShape<dim>
    {
    public:
      void
      declare(Section &section) override
      {
        section.add("Center", center, "[length]");
        radius.declare(section,
                       "Radius",
                       "number, or formula in t where there is no friction [length]",
                       positive);
        section.add("Hollow", hollow, "yes: the body is inside, in a spherical seat");
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
        const Tensor<1, dim> r        = x - center;
        const double         distance = r.norm();
        Tensor<1, dim>       n        = r;
        if (distance > 0)
          n /= distance;
        else
          n[dim - 1] = 1; // in the very center all directions are alike
        Tensor<2, dim> curvature;
        if (distance > 0)
          curvature = (unit_symmetric_tensor<dim>() - outer_product(n, n)) / distance;
        return hollow ? ObstaclePoint<dim>{radius - distance, -n, -curvature} :
                        ObstaclePoint<dim>{distance - radius, n, curvature};
      }

    private:
      Point<dim>     center;
      ShapeParameter radius{1};
      bool           hollow = false;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_sphere()
  {
    return std::make_unique<Sphere<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_sphere();
  template std::unique_ptr<ObstacleShape<3>>
  make_sphere();
} // namespace Signorini
