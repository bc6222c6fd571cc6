// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/solid/rigid_body.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  class Section;

  /// The projection of a slave point onto a rigid surface.
  template <int dim>
  struct ObstaclePoint
  {
    /// Distance from the surface [length], positive outside of the obstacle.
    double                 gap;
    dealii::Tensor<1, dim> normal; ///< unit, out of the obstacle
    /// Second derivatives of the gap; zero where the surface is flat, or sharp.
    dealii::Tensor<2, dim> curvature{};
  };

  /// The shape of a rigid surface, which has no mesh: a file in contact/obstacles and a line in the
  /// registry.
  template <int dim>
  class ObstacleShape
  {
  public:
    virtual ~ObstacleShape() = default;

    /// Declare the keys of this shape, beside `Shape`, in the obstacle's section.
    virtual void
    declare(Section &section) = 0;

    /// Read the data that is in a file; called after declare() and before any other function.
    /// Throws SceneError.
    /// @param folder where the file is searched after the working directory
    virtual void
    read_file([[maybe_unused]] const std::string &folder)
    {}

    /// True if the shape changes with time, apart from the motion of its obstacle.
    virtual bool
    depends_on_time() const
    {
      return false;
    }

    /// Set the time of the shape; initially it is 0.
    virtual void
    set_time(double /*t*/)
    {}

    /// The projection of a point of a slave surface in the reference configuration: the closest
    /// point, or what a theory uses instead (as Hertz' does for paraboloids).
    virtual ObstaclePoint<dim>
    closest(const dealii::Point<dim> &x) const = 0;

    /// True if the obstacle has no surface of its own, but that of the slave: each slave point is
    /// paired with the point of the rigid body that was in the same place at the start.
    virtual bool
    is_attached() const
    {
      return false;
    }

    /// False if only the gap of the reference configuration is known, so that the shape has no
    /// closest-point projection.
    virtual bool
    has_closest_point(const dealii::Point<dim> & /*x*/, double /*length*/) const
    {
      return true;
    }

    /// The closest point of the surface in any configuration; the gap is the distance [length],
    /// negative inside.
    /// @param x point in the coordinates of the obstacle
    /// @param length length scale, relative to which steps of finite differences are small
    virtual ObstaclePoint<dim>
    closest_point(const dealii::Point<dim> &x, [[maybe_unused]] double length) const
    {
      return closest(x);
    }
  };

  /// A rigid obstacle of the scene.
  template <int dim>
  struct Obstacle
  {
    std::string                         name;
    std::string                         type = "plane";
    std::shared_ptr<ObstacleShape<dim>> shape;
    /// Motion and loads of the obstacle.
    RigidBody<dim> body;

    /// Declare the keys of an obstacle in its section.
    void
    declare(Section &section);
  };
} // namespace Signorini
