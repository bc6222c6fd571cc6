// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A rigid body without a surface of its own, see ObstacleShape::is_attached(). What searches
    /// the space for obstacles finds no surface that faces a body.
    template <int dim>
    class Attached : public ObstacleShape<dim>
    {
    public:
      void
      declare(Section & /*section*/) override
      {}

      bool
      is_attached() const override
      {
        return true;
      }

      ObstaclePoint<dim>
      closest(const Point<dim> & /*x*/) const override
      {
        return {0., Tensor<1, dim>()};
      }

      bool
      has_closest_point(const Point<dim> & /*x*/, double /*length*/) const override
      {
        return false;
      }
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_attached()
  {
    return std::make_unique<Attached<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_attached();
  template std::unique_ptr<ObstacleShape<3>>
  make_attached();
} // namespace Signorini
