// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Signorini
{
  /// Where a rigid body is: turned about its reference point by a rotation vector of any length
  /// (2D: an angle), then moved,
  ///
  ///   x(X) = X_0 + t + R (X - X_0),   R = exp(w^).
  ///
  /// A change of its degrees of freedom by (dt, dw) moves a point of it by dt + (J dw) cross r,
  /// with the arm r = R (X - X_0) and the left Jacobian J of the rotation vector (Chirikjian,
  /// Stochastic Models, Information Theory, and Lie Groups 2 (2012) 10.86). As everywhere,
  /// rotations count as the length by which they move what is one lever away.
  template <int dim>
  class RigidPose
  {
  public:
    static constexpr unsigned int n_rotations = dim == 2 ? 1 : 3;
    static constexpr unsigned int n_dofs      = 2 * dim; ///< in 2D one of them is not used

    using Vector = dealii::Tensor<1, dim>;

    /// @param motion degrees of freedom: translation, rotation * lever [length]
    RigidPose(const dealii::Point<dim>         &reference,
              const std::array<double, n_dofs> &motion,
              double                            rotation_length_scale);

    /// The reference position of the body's point that is now at x.
    dealii::Point<dim>
    to_body(const dealii::Point<dim> &x) const;

    /// A direction of the body, rotated to the current configuration.
    Vector
    to_space(const Vector &direction) const
    {
      return turn * direction;
    }

    dealii::Tensor<2, dim>
    to_space(const dealii::Tensor<2, dim> &tensor) const
    {
      return turn * tensor * transpose(turn);
    }

    /// The arm r of the point that is now at x, from the center of rotation.
    Vector
    arm(const dealii::Point<dim> &x) const
    {
      return x - center;
    }

    /// The change of u.n of the point now at x is the sum of these times changes of the degrees of
    /// freedom.
    std::array<double, n_dofs>
    row(const dealii::Point<dim> &x, const Vector &n) const;

    /// The derivative of the spin J dw about axis i [radian] by the degrees of freedom (2D: about
    /// z).
    std::array<double, n_dofs>
    spin(unsigned int i) const;

    /// Moments about the center (2D: about z).
    using Moment = dealii::Tensor<1, n_rotations>;

    /// J^T M / lever: what a moment is to the rotational degrees of freedom, by the work that it
    /// does.
    Moment
    on_rotations(const Moment &moment) const;

    /// Back again. After whole turns in 3D J is singular: only the component along the axis is
    /// known then, and components that are not are not numbers.
    Moment
    moment_of(const Moment &on_rotations) const;

  private:
    dealii::Point<dim>             reference, center;
    dealii::Tensor<2, dim>         turn;
    dealii::Tensor<2, n_rotations> jacobian; ///< J / lever
  };
} // namespace Signorini
