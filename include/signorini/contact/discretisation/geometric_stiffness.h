#pragma once

#include <signorini/contact/discretisation/contact_rows.h>
#include <signorini/contact/discretisation/gap_operator.h>

namespace Signorini
{
  /// G = sum_q p_q w_q d2 g_q/du2 over the contact points and seams, on free degrees of freedom:
  /// how the forces of given pressures change as surfaces move. K - G is the derivative of the
  /// forces out of balance, in the condensed and in the saddle point form.
  ///
  /// No matrix: that of a point between two faces of degree 2 in space has 54 x 54 entries, and is
  /// the product of what a few hundred operations tell.
  /// @param rows those of the gap operator
  /// @param pressure at them
  template <int dim>
  std::unique_ptr<GeometricStiffness>
  geometric_stiffness(const Elasticity<dim>                  &elasticity,
                      const std::vector<ContactSurface<dim>> &surfaces,
                      const ContactRows                      &rows,
                      const LA::Vector                       &pressure);
} // namespace Signorini
