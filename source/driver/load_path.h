// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <vector>

namespace Signorini
{
  /// @return the tangential tractions of all pairs at the nodes, component by component.
  /// Collective.
  /// @param snapshot the solution
  template <int dim>
  std::vector<LA::Vector>
  all_tangential_tractions(const Snapshot<dim> &snapshot);

  /// @return whether tangential tractions are negligible beside the pressure, so that the solution
  /// does not depend on the path. Collective.
  /// @param tractions of the solution
  /// @param snapshot the solution
  template <int dim>
  bool
  are_negligible(const std::vector<LA::Vector> &tractions, const Snapshot<dim> &snapshot);

  /// @return the difference of tractions relative to the latter ones: the sums of their absolute
  /// values over all nodes and components; zero if these are zero. Collective.
  /// @param coarse tractions after one load step
  /// @param fine after two of half the length
  double
  path_error(const std::vector<LA::Vector> &coarse, const std::vector<LA::Vector> &fine);
} // namespace Signorini
