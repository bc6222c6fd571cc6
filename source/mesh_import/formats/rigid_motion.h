// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace Signorini
{
  /// A rigid motion x -> R x + c with the rotation R and the shift c [length].
  struct RigidMotion
  {
    dealii::Tensor<2, 3> rotation = dealii::unit_symmetric_tensor<3>();
    dealii::Tensor<1, 3> shift;

    /// @return the moved point.
    /// @param x a point
    dealii::Point<3>
    operator()(const dealii::Point<3> &x) const
    {
      return dealii::Point<3>(rotation * x + shift);
    }

    /// @return a translation.
    /// @param by the shift [length]
    static RigidMotion
    translation(const dealii::Tensor<1, 3> &by);

    /// @return a right-handed rotation about an axis.
    /// @param a,b two points of the axis, which is directed from a to b
    /// @param angle [radian]
    static RigidMotion
    about_axis(const dealii::Point<3> &a, const dealii::Point<3> &b, double angle);

    /// @return the motion from the coordinates of a Cartesian system to global coordinates.
    /// @param origin of the system
    /// @param on_x a point on its x axis
    /// @param in_xy a point in its xy plane, not on the x axis
    static RigidMotion
    of_system(const dealii::Point<3> &origin,
              const dealii::Point<3> &on_x,
              const dealii::Point<3> &in_xy);

    /// @return this motion followed by another one.
    /// @param next the motion that follows
    RigidMotion
    then(const RigidMotion &next) const;
  };
} // namespace Signorini
