// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <string>

namespace Signorini
{
  /// Writes NAME_NNNN.pvtu and its pieces (NNNN is the step) and returns its name: the slave
  /// faces of all pairs at reference positions, with `displacement`, `traction` (the force on the
  /// slave by area), `pressure` (positive in compression), `gap` (NaN where nothing was found to
  /// touch), `status` (1 active, 0 not, 2 to and fro), and `pair` (a number from 0, its name in the
  /// field data `pair_names`). A face that belongs to two pairs is there twice. Collective.
  template <int dim>
  std::string
  write_contact(const Snapshot<dim> &snapshot,
                const std::string   &directory,
                const std::string   &name = "contact");
} // namespace Signorini
