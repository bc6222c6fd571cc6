// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace Signorini
{
  /// x -> R x + c.
  struct RigidMotion
  {
    dealii::Tensor<2, 3> rotation = dealii::unit_symmetric_tensor<3>();
    dealii::Tensor<1, 3> shift;

    dealii::Point<3>
    operator()(const dealii::Point<3> &x) const
    {
      return dealii::Point<3>(rotation * x + shift);
    }

    static RigidMotion
    translation(const dealii::Tensor<1, 3> &by);

    /// By an angle [radian] about the axis from a to b, right-handed.
    static RigidMotion
    about_axis(const dealii::Point<3> &a, const dealii::Point<3> &b, double angle);

    /// From a Cartesian system to the global one: its origin, a point on its x axis and one in its
    /// xy plane, not on a line.
    static RigidMotion
    of_system(const dealii::Point<3> &origin,
              const dealii::Point<3> &on_x,
              const dealii::Point<3> &in_xy);

    /// First this motion, then another one.
    RigidMotion
    then(const RigidMotion &next) const;
  };
} // namespace Signorini
