// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// From forces per area at rest, which methods know, to Cauchy's pressure, which the output has.
  /// At small deformation both are the same.
  /// @param pressure at the nodes, see nodal_field()
  template <int dim>
  void
  to_present_areas(const Snapshot<dim> &snapshot, unsigned int pair, LA::Vector &pressure);
} // namespace Signorini
