// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"

namespace Signorini
{
  /// How the forces of given tractions change as surfaces move, on free degrees of freedom: of
  /// pressures G = sum_q p_q w_q d2 g_q/du2 over the contact points and segment edges. K - G is the
  /// derivative of the forces out of balance, in the condensed and in the saddle point form.
  ///
  /// The tangential traction T = sum_a t_a tau_a on the slave does the work T.(dS - dM(xi)) in a
  /// virtual displacement d, S and M the slave's point and its projection. With the change u of the
  /// displacement the tangents tau_a turn with the contact normal n and about it, by the angle
  /// omega, and the projection moves on by dxi:
  ///
  ///   G(d, u) = w [-(T.dn) n.(dS - dM) + omega T'.(dS - dM) - dxi_b T.dM,b],
  ///
  /// T' is T turned by ninety degrees. With the tangents y_a, the metric A, the curvature K of the
  /// master, the gap g, and H = A - g K (Laursen, Computational Contact and Impact Mechanics,
  /// Springer 2002, chapter 5):
  ///
  ///   dxi = H^-1 (w + g m),  w_a = y_a.(uS - uM),  m_a = n.uM,a
  ///   dn  = -y_a A^ab (m_b + K_bc dxi_c),
  ///
  /// and omega, the turn of the slave's material about n, is that of ConvectedFrame,
  ///
  ///   tr U omega = tau_2.uS,1 - tau_1.uS,2 - (n.F E_1) tau_2.dn + (n.F E_2) tau_1.dn,
  ///
  /// uS,j being derivatives along the vectors E_j at rest. It is not symmetric: the forces have no
  /// potential unless the tractions follow from one.
  ///
  /// No matrix: that of a point between two faces of degree 2 in space has 54 x 54 entries, and is
  /// the product of what a few hundred operations tell.
  /// @param rows those of the gap operator
  /// @param traction at them
  template <int dim>
  std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<dim>                  &elasticity,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactRows                      &rows,
                      const PointVectors                     &traction);
} // namespace Signorini
