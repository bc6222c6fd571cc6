// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/search.h"
#include <signorini/contact/obstacles/obstacle.h>

#include <cmath>

namespace Signorini
{
  // The second variation of the gap g of a point x of the slave, which makes Newton's method
  // quadratic where surfaces move. It matters where there is pressure only.

  /// True if a point is close enough to its projection to carry pressure, and so to contribute to
  /// the geometric stiffness. (Half a face is generous on purpose: under the edges of a punch,
  /// points a tenth of a face apart do carry pressure, and without them convergence was linear.)
  /// @param face_size diameter of the face
  inline bool
  may_carry_pressure(const double distance, const double face_size)
  {
    return std::abs(distance) <= 0.5 * face_size;
  }

  /// The second variation of the gap on a face y(xi) of a body, whose closest point satisfies (x -
  /// y).y_a = 0 (Laursen and Simo, Int. J. Numer. Methods Eng. 36 (1993) 3451; here in the form
  /// without division by g):
  ///
  ///   - [w.A^-1 K H^-1 w' + m.H^-1 w' + w.H^-1 m' + g m.H^-1 m'],
  ///
  /// with w_a = y_a.(u^S - u^M), m_a = n.u^M_a, the metric A, the curvature K_ab = n.y_ab, and H =
  /// A - g K. The factors contain g, which is known only on the rank of the slave point: this
  /// function, called on the rank of the master face, returns A and K in their place.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_master(const FacePatch<dim>         &patch,
                             const dealii::Point<dim - 1> &xi,
                             const dealii::Tensor<1, dim> &n);

  /// Complete second_variation_of_master() by the factors, on the slave's rank. Empty where the
  /// closest point is on the edge of a face, since the gap has a kink there.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_bodies(const dealii::Point<dim>    &x,
                             const MasterProjection<dim> &master_point);

  /// The second variation of a segment edge, for small gaps. The edge follows the master face in
  /// the plane of the slave, so that the integral of p (u^S - u^M).n over the segment changes by p
  /// (u^S - u^M).n times the area that v.(u^M - u^S) adds, with v outward in that plane. The
  /// segments on both sides together contain the jump of n, which on flat faces is all the
  /// curvature that a surface has. Each side takes the symmetric part only: the sum is symmetric,
  /// because gaps do not jump and the jump of n is along v.
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_edge(const dealii::Tensor<1, dim> &n, const dealii::Tensor<1, dim> &v);

  /// The second variation of the gap of an obstacle with second derivatives Q of its gap function:
  /// with the arm r of x, the change w = u - dt - s cross r of x relative to the obstacle, and the
  /// spin s,
  ///
  ///   w.Q w' - n.(s cross w') - n.(s' cross w) - [n.(s cross (s' cross r)) + the same of s', s]/2.
  ///
  /// @param first_dof first rigid-body degree of freedom of the obstacle; invalid if it is fixed
  template <int dim>
  GapSecondVariation<dim>
  second_variation_of_obstacle(const ObstaclePoint<dim>       &obstacle_point,
                               const RigidPose<dim>           &pose,
                               const dealii::Point<dim>       &x,
                               dealii::types::global_dof_index first_dof);
} // namespace Signorini
