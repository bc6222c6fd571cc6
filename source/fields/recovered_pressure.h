// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// The pressure of one pair at the nodes of the slave, as a nodal_field(). Of degree 1 that is
  /// the nodal pressure itself. Of degree 2 that is not: with the dual basis it is a mean over a
  /// shape function, whose second moments differ between vertices and mid-side nodes, and with the
  /// standard basis it oscillates between them; both errors are of the order h^2. But the means
  /// m_v = int phi_v lambda dA / int phi_v dA with the linear functions phi_v of the vertices are
  /// free of that oscillation, and as accurate as forces. From them follows the pressure at the
  /// vertices, whose means they are:
  ///
  ///   q = m - (M q - q),  M q - q = (A q - q + G.d)/2,
  ///
  /// where A q are such means of the linear interpolant of q, which overestimate the effect of
  /// curvature twice, G the gradient, and d = int phi_v (x - x_v) dA / int phi_v dA, not zero at
  /// rims and where neighbours differ in size. Iterated; mid-side nodes and centers then take the
  /// cubic (Hermite) interpolants of values and gradients. All that takes a neighbourhood that is
  /// in contact as a whole; at the edge of the contact zone vertices have m, open nodes zero. Exact
  /// for linear pressures; of smooth ones, errors of the order h^4, at rims h^3,
  /// at corners h^2. Computed once for each snapshot and pair. Collective.
  template <int dim>
  const LA::Vector &
  recovered_pressure(const Snapshot<dim> &snapshot, unsigned int pair);
} // namespace Signorini
