// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/probes.h"
#include "fields/snapshot.h"
#include "output/json.h"

#include <vector>

namespace Signorini
{
  /// At each probe its place and displacement; in bodies stress by names ("xx", ...), principal
  /// stresses (the largest first) and von Mises stress; on pairs pressure and gap (null where there
  /// is no candidate for contact). Of lines a list of that. Collective.
  template <int dim>
  Json
  probe_results(const Snapshot<dim> &snapshot, const std::vector<Probe<dim>> &probes);
} // namespace Signorini
