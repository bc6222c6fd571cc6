// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// The pressure of one pair at the nodes of the slave, as a nodal_field(). With degree 1 it is
  /// the nodal pressure itself. With degree 2 nodal pressures are not accurate: with the dual basis
  /// they are means over a shape function, whose second moments differ between vertices and
  /// mid-side nodes, and with the standard basis they oscillate between them; both errors are of
  /// the order h^2. The means m_v = int phi_v lambda dA / int phi_v dA with the linear functions
  /// phi_v of the vertices, however, are free of that oscillation, and as accurate as forces. They
  /// determine the pressure q at the vertices, whose means they are:
  ///
  ///   q = m - (M q - q),  M q - q = (A q - q + G.d)/2,
  ///
  /// where A q are the means of the linear interpolant of q, which overestimate the effect of
  /// curvature by a factor of two, G is the gradient, and d = int phi_v (x - x_v) dA / int phi_v
  /// dA, which is not zero at boundaries of the surface and where neighbours differ in size. The
  /// equation is iterated; mid-side nodes and centres then have the cubic (Hermite) interpolants of
  /// values and gradients. This needs a neighbourhood that is entirely in contact; at the edge of
  /// the contact zone vertices have the value m, and open nodes zero. The result is exact for
  /// linear pressures; for smooth ones, errors are of the order h^4, at boundaries h^3, at corners
  /// h^2. Computed once for each snapshot and pair. Collective.
  /// @param snapshot the solution, which stores the result
  /// @param pair its index
  /// @return the pressure, valid as long as the snapshot or a copy of it
  template <int dim>
  const LA::Vector &
  recovered_pressure(const Snapshot<dim> &snapshot, unsigned int pair);

  /// @return any density by area, for example a component of the traction, at the nodes of the
  /// slave, as recovered_pressure() for the pressure. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param values one for each row of the gap operator, by reference area
  /// @param is_positive whether extrapolated values are not to be negative
  template <int dim>
  LA::Vector
  recovered_density(const Snapshot<dim> &snapshot,
                    unsigned int         pair,
                    const LA::Vector    &values,
                    bool                 is_positive);
} // namespace Signorini
