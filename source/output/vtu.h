// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <string>

namespace Signorini
{
  /// Write solution_NNNN.pvtu and its pieces (NNNN is the step). At reference positions:
  /// `displacement`, `von_mises`, `stress` (three-dimensional, with sigma_zz in 2D: nine
  /// components, positive in tension; discontinuous between cells), `principal_stress_1` (the
  /// largest) to `_3`, and for each cell `body` (its name in the field data `body_names`) and
  /// `subdomain` (the rank). Throws OutputError. Collective.
  /// @param snapshot the solution
  /// @param directory in which files are written
  /// @return the name of the record
  template <int dim>
  std::string
  write_bodies(const Snapshot<dim> &snapshot, const std::string &directory);
} // namespace Signorini
