// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <string>

namespace Signorini
{
  /// Writes solution_NNNN.pvtu and its pieces (NNNN is the step) and returns its name. At
  /// reference positions: `displacement`, `von_mises`, `stress` (in space, so also sigma_zz of 2D:
  /// nine components, tension positive; discontinuous between cells), `principal_stress_1` (the
  /// largest) to `_3`, and of each cell `body` (its name in the field data `body_names`) and
  /// `subdomain` (the rank). Collective.
  template <int dim>
  std::string
  write_bodies(const Snapshot<dim> &snapshot, const std::string &directory);
} // namespace Signorini
