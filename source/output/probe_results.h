// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/probes.h"
#include "fields/snapshot.h"
#include "output/json.h"

#include <vector>

namespace Signorini
{
  /// @return position and displacement at each probe; in bodies also stress components by name
  /// ("xx", ...), principal stresses (the largest first) and von Mises stress; on pairs also
  /// pressure and gap (null where the surfaces are too far apart for the search). Lines have a list
  /// of these. Collective.
  /// @param snapshot the solution
  /// @param probes of the scene
  template <int dim>
  Json
  probe_results(const Snapshot<dim> &snapshot, const std::vector<Probe<dim>> &probes);
} // namespace Signorini
