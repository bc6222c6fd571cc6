// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"
#include <signorini/parameters/section.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A half space.
    template <int dim>
    class Plane : public ObstacleShape<dim>
    {
    public:
      Plane()
      {
        normal[dim - 1] = 1;
      }

      void
      declare(Section &section) override
      {
        section.add("Point", point, "a point of the plane [length]");
        section.add("Normal", normal, "out of the obstacle, towards the body; any length");
        if (normal.norm() == 0)
          section.fail("Normal", "must not be zero");
      }

      ObstaclePoint<dim>
      closest(const Point<dim> &x) const override
      {
        const Tensor<1, dim> n = normal / normal.norm();
        return {(x - point) * n, n};
      }

    private:
      Point<dim> point, normal;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_plane()
  {
    return std::make_unique<Plane<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_plane();
  template std::unique_ptr<ObstacleShape<3>>
  make_plane();
} // namespace Signorini
