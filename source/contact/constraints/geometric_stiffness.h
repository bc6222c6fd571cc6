// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"

namespace Signorini
{
  /// The contact geometric stiffness on free degrees of freedom, for given tractions. For pressures
  /// it is G = sum_q p_q w_q d2 g_q/du2 over the contact points and segment edge points; K - G is
  /// the derivative of the residual, in the condensed and in the saddle point form (doc/theory, 5).
  ///
  /// The tangential traction T = sum_a t_a tau_a on the slave does the work T.(dS - dM(xi)) in a
  /// virtual displacement d, S and M being the slave's point and its projection. With the change u
  /// of the displacement, the tangents tau_a rotate with the contact normal n and about it by the
  /// angle omega, and the projection moves by dxi:
  ///
  ///   G(d, u) = w [-(T.dn) n.(dS - dM) + omega T'.(dS - dM) - dxi_b T.dM,b],
  ///
  /// where T' is T rotated by ninety degrees. With the tangents y_a, the metric A, the curvature K
  /// of the master, the gap g, and H = A - g K (Laursen, Computational Contact and Impact
  /// Mechanics, Springer 2002, chapter 5):
  ///
  ///   dxi = H^-1 (w + g m),  w_a = y_a.(uS - uM),  m_a = n.uM,a
  ///   dn  = -y_a A^ab (m_b + K_bc dxi_c),
  ///
  /// and omega, the rotation of the slave's material about n, is that of ConvectedFrame,
  ///
  ///   tr U omega = tau_2.uS,1 - tau_1.uS,2 - (n.F E_1) tau_2.dn + (n.F E_2) tau_1.dn,
  ///
  /// uS,j being derivatives along the reference vectors E_j. The tangential part is not symmetric:
  /// the forces have no potential unless the tractions follow from one.
  ///
  /// No matrix is stored: that of a point between two faces of degree 2 in 3D has 54 x 54 entries,
  /// while its product takes a few hundred operations.
  /// @param rows those of the gap operator
  /// @param traction at the rows: normal pressure, then tangential components [force/length^2]
  template <int dim>
  std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<dim>                  &elasticity,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactRows                      &rows,
                      const PointVectors                     &traction);
} // namespace Signorini
