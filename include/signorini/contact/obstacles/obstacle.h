#pragma once

#include <signorini/elasticity/rigid_body.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The place on a rigid surface that belongs to a slave point.
  template <int dim>
  struct ObstaclePlace
  {
    double                 gap;    ///< positive outside of the obstacle
    dealii::Tensor<1, dim> normal; ///< unit, out of the obstacle
  };

  /// A rigid shape that is never meshed: one file under contact/obstacles and one line in the
  /// registry.
  template <int dim>
  class ObstacleShape
  {
  public:
    virtual ~ObstacleShape() = default;

    /// The keys of this shape, beside `Shape`, in the obstacle's section.
    virtual void
    declare(Section &section) = 0;

    virtual ObstaclePlace<dim>
    closest(const dealii::Point<dim> &x) const = 0;
  };

  /// A rigid obstacle of the scene.
  template <int dim>
  struct Obstacle
  {
    std::string                         name;
    std::string                         type = "plane";
    std::shared_ptr<ObstacleShape<dim>> shape;
    /// How it moves. Contact is linearised about the reference position, thesis (44): the gap falls
    /// by displacement . normal.
    RigidBody<dim> body;

    void
    declare(Section &section);
  };
} // namespace Signorini
