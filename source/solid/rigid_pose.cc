// SPDX-License-Identifier: Apache-2.0
#include <signorini/solid/rigid_pose.h>

#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The matrix W with W v = w x v.
    Tensor<2, 3>
    cross_matrix(const Tensor<1, 3> &w)
    {
      Tensor<2, 3> result;
      result[0][1] = -w[2];
      result[0][2] = w[1];
      result[1][2] = -w[0];
      // Three entries determine the antisymmetric matrix.
      result -= transpose(result);
      return result;
    }

    /// The coefficients (1 - cos a)/a^2 and (a - sin a)/a^3 of the rotation (doc/theory, (5.10),
    /// (5.11)); below a = 0.01 by their series, since the differences cancel.
    std::array<double, 2>
    coefficients(const double a)
    {
      const double square = a * a;
      if (a < 0.01)
        return {{0.5 - square / 24 * (1 - square / 30), 1. / 6 - square / 120 * (1 - square / 42)}};
      return {{(1 - std::cos(a)) / square, (a - std::sin(a)) / (square * a)}};
    }

    template <int n>
    Tensor<2, n>
    identity()
    {
      Tensor<2, n> result;
      for (unsigned int d = 0; d < n; ++d)
        result[d][d] = 1;
      return result;
    }
  } // namespace



  // Rotation matrix R = exp(W) and left Jacobian J_l by Rodrigues' formula (doc/theory, (5.10),
  // (5.11)). The Jacobian is divided by the length scale, since the unknowns are rotations times
  // that length.
  template <int dim>
  RigidPose<dim>::RigidPose(const Point<dim>                 &reference,
                            const std::array<double, n_dofs> &motion,
                            const double                      rotation_length_scale)
    : reference(reference)
    , center(reference)
  {
    for (unsigned int d = 0; d < dim; ++d)
      center[d] += motion[d];
    if constexpr (dim == 2)
      {
        const double angle = motion[2] / rotation_length_scale;
        turn[0][0] = turn[1][1] = std::cos(angle);
        turn[1][0]              = std::sin(angle);
        turn[0][1]              = -turn[1][0];
        jacobian[0][0]          = 1;
      }
    else
      {
        Tensor<1, 3> w;
        for (unsigned int d = 0; d < 3; ++d)
          w[d] = motion[3 + d] / rotation_length_scale;
        const Tensor<2, 3> W = cross_matrix(w), I = identity<3>();
        const auto [b, c] = coefficients(w.norm());
        // sin(a)/a = 1 - c a^2
        turn     = I + (1 - c * w.norm_square()) * W + b * W * W;
        jacobian = I + b * W + c * W * W;
      }
    jacobian /= rotation_length_scale;
  }



  // The inverse motion: from the present position of a point of the body to that in the reference
  // configuration, in which the shape is given.
  template <int dim>
  Point<dim>
  RigidPose<dim>::to_body(const Point<dim> &x) const
  {
    return reference + transpose(turn) * arm(x);
  }



  // The row n . u^M of doc/theory, (5.13).
  template <int dim>
  std::array<double, RigidPose<dim>::n_dofs>
  RigidPose<dim>::row(const Point<dim> &x, const Vector &n) const
  {
    // n . (spin cross r) = spin . (r cross n)
    const Vector               r = arm(x);
    std::array<double, n_dofs> result{};
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = n[d];
    Tensor<1, n_rotations> of_spin;
    if constexpr (dim == 2)
      of_spin[0] = r[0] * n[1] - r[1] * n[0];
    else
      of_spin = cross_product_3d(r, n);
    for (unsigned int i = 0; i < n_rotations; ++i)
      result[dim + i] = (of_spin * jacobian)[i];
    return result;
  }



  // The row of spin component i over the unknowns: the left Jacobian maps rates of the rotation
  // vector to spins.
  template <int dim>
  std::array<double, RigidPose<dim>::n_dofs>
  RigidPose<dim>::spin(const unsigned int i) const
  {
    std::array<double, n_dofs> result{};
    for (unsigned int j = 0; j < n_rotations; ++j)
      result[dim + j] = jacobian[i][j];
    return result;
  }



  // Moments work on spins; their power on the unknowns is that of M . J_l.
  template <int dim>
  typename RigidPose<dim>::Moment
  RigidPose<dim>::on_rotations(const Moment &moment) const
  {
    return moment * jacobian;
  }



  // Inverse of on_rotations().
  template <int dim>
  typename RigidPose<dim>::Moment
  RigidPose<dim>::moment_of(const Moment &on_rotations) const
  {
    constexpr double singular = 1e-8;
    const double     scale    = std::pow(jacobian.norm(), n_rotations);
    if (std::abs(determinant(jacobian)) > singular * scale)
      return on_rotations * invert(jacobian);
    // At a full turn J_l is singular: it keeps the component along the axis of rotation and
    // annihilates those across. A component along a coordinate axis that is that axis is known, the
    // others are not (NaN).
    Moment       result;
    const double rotation_length_scale = std::sqrt(1 / (jacobian * transpose(jacobian)).norm());
    for (unsigned int i = 0; i < n_rotations; ++i)
      result[i] = std::abs(rotation_length_scale * jacobian[i][i] - 1) < singular ?
                    rotation_length_scale * on_rotations[i] :
                    std::numeric_limits<double>::quiet_NaN();
    return result;
  }



  template class RigidPose<2>;
  template class RigidPose<3>;
} // namespace Signorini
