// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// Convert a pressure from force per reference area, the unknown of the methods, to Cauchy
  /// pressure, which is reported (doc/theory, 6.5). At small strain both are the same. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param pressure at the nodes, see nodal_field(), which is changed
  template <int dim>
  void
  to_present_areas(const Snapshot<dim> &snapshot, unsigned int pair, LA::Vector &pressure);
} // namespace Signorini
