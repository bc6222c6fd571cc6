// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Signorini
{
  /// The pose of a rigid body: rotated about its reference point by a rotation vector of any length
  /// (2D: an angle), then translated (doc/theory, (5.10)),
  ///
  ///   x(X) = X_0 + t + R (X - X_0),   R = exp(w^).
  ///
  /// A change of its degrees of freedom by (dt, dw) displaces a point by dt + (J dw) x r, with the
  /// arm r = R (X - X_0) and the left Jacobian J of the rotation vector (Chirikjian, Stochastic
  /// Models, Information Theory, and Lie Groups 2 (2012) 10.86; doc/theory, (5.11)). Rotational
  /// degrees of freedom are rotations times a length scale.
  template <int dim>
  class RigidPose
  {
  public:
    static constexpr unsigned int n_rotations = dim == 2 ? 1 : 3;
    static constexpr unsigned int n_dofs      = 2 * dim; ///< in 2D one of them is not used

    using Vector = dealii::Tensor<1, dim>;

    /// @param reference reference point
    /// @param motion degrees of freedom: translation, rotation times length scale [length]
    /// @param rotation_length_scale see Displacements::rotation_length_scale()
    RigidPose(const dealii::Point<dim>         &reference,
              const std::array<double, n_dofs> &motion,
              double                            rotation_length_scale);

    /// The reference position of the material point that is at x.
    dealii::Point<dim>
    to_body(const dealii::Point<dim> &x) const;

    /// The current position of the material point whose reference position is X.
    dealii::Point<dim>
    position(const dealii::Point<dim> &X) const
    {
      return center + turn * (X - reference);
    }

    /// A direction of the body, rotated to the current configuration.
    Vector
    to_space(const Vector &direction) const
    {
      return turn * direction;
    }

    /// A tensor of the body, such as a curvature, rotated to the current configuration.
    dealii::Tensor<2, dim>
    to_space(const dealii::Tensor<2, dim> &tensor) const
    {
      return turn * tensor * transpose(turn);
    }

    /// The arm r of the point at x from the displaced reference point.
    Vector
    arm(const dealii::Point<dim> &x) const
    {
      return x - center;
    }

    /// The row of u.n at the point at x: its change is the sum of these entries times the changes
    /// of the degrees of freedom (doc/theory, (5.13)).
    std::array<double, n_dofs>
    row(const dealii::Point<dim> &x, const Vector &n) const;

    /// The derivatives of component i of the spin J dw [radian] with respect to the degrees of
    /// freedom; in 2D there is one component, about z.
    std::array<double, n_dofs>
    spin(unsigned int i) const;

    /// Moments about the center (2D: about z).
    using Moment = dealii::Tensor<1, n_rotations>;

    /// J^T M divided by the length scale: the forces on the rotational degrees of freedom that are
    /// work-conjugate to a moment.
    Moment
    on_rotations(const Moment &moment) const;

    /// The inverse of on_rotations(). After full turns in 3D J is singular: then only the component
    /// along the axis is determined, and the others are NaN.
    Moment
    moment_of(const Moment &on_rotations) const;

  private:
    dealii::Point<dim>             reference, center;
    dealii::Tensor<2, dim>         turn;
    dealii::Tensor<2, n_rotations> jacobian; ///< J / lever
  };
} // namespace Signorini
