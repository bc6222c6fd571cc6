// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/search.h"
#include <signorini/contact/obstacles/obstacle.h>

#include <cmath>

namespace Signorini
{
  // The second variation of the gap g of a point x of the slave, which makes Newton's method
  // quadratic where surfaces move. It matters where there is pressure only.

  /// Points that are farther from their projection can hardly have a pressure. (Under the edges of
  /// a punch they can: at a tenth of a face, convergence was linear there.)
  /// @param face_size a diameter
  inline bool
  may_carry_pressure(const double distance, const double face_size)
  {
    return std::abs(distance) <= 0.5 * face_size;
  }

  /// On a face y(xi) of a body, whose closest point makes (x - y).y_a = 0 (Laursen and Simo, Int.
  /// J. Numer. Methods Eng. 36 (1993) 3451; here in the form without division by g):
  ///
  ///   - [w.A^-1 K H^-1 w' + m.H^-1 w' + w.H^-1 m' + g m.H^-1 m'],
  ///
  /// with w_a = y_a.(u^S - u^M), m_a = n.u^M_a, the metric A, the curvature K_ab = n.y_ab, and
  /// H = A - g K. All but the factors, which need g: A and K in their place.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_master(const FacePatch<dim>         &patch,
                             const dealii::Point<dim - 1> &xi,
                             const dealii::Tensor<1, dim> &n);

  /// With the factors. Nothing where the closest place is on the rim of a face: the gap bends
  /// abruptly there.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_bodies(const dealii::Point<dim>    &x,
                             const MasterProjection<dim> &master_point);

  /// Where a segment ends with its master face, and gaps are small: the end follows the face, in
  /// the plane of the slave, so that the integral of p (u^S - u^M).n over the segment changes by p
  /// (u^S - u^M).n times the area that v.(u^M - u^S) adds, v outward in that plane. The segments on
  /// both sides together have the jump of n, which on flat faces is all the curvature that a
  /// surface has; of each the symmetric part is taken, since the sum is symmetric (as
  /// gaps do not jump, the jump of n is along v).
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_edge(const dealii::Tensor<1, dim> &n, const dealii::Tensor<1, dim> &v);

  /// On an obstacle, whose gap has the second derivatives Q in space: with the arm r of x, the
  /// change w = u - dt - s cross r of x relative to the obstacle, and the spin s,
  ///
  ///   w.Q w' - n.(s cross w') - n.(s' cross w) - [n.(s cross (s' cross r)) + the same of s', s]/2.
  ///
  /// @param first_dof of the obstacle; invalid if it is at rest
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_obstacle(const ObstaclePoint<dim>       &obstacle_point,
                               const RigidPose<dim>           &pose,
                               const dealii::Point<dim>       &x,
                               dealii::types::global_dof_index first_dof);
} // namespace Signorini
