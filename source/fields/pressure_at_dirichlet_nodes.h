// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// Pressures at nodes that carry none of their own, see carries_pressure(), and at their
  /// neighbours, which take over: what these have is the mean about the center of both functions.
  /// From there on linearly, by the slopes of the parts of faces beyond; not below zero. On the
  /// axis of rings nothing is to be done. Collective.
  /// @param raw pressure as nodal_field()
  /// @param pressure the values at these nodes are changed
  template <int dim>
  void
  extrapolate_to_dirichlet_nodes(const Snapshot<dim> &snapshot,
                                 unsigned int         pair,
                                 const LA::Vector    &raw,
                                 LA::Vector          &pressure);
} // namespace Signorini
