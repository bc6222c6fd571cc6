// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <string>

namespace Signorini
{
  /// Write NAME_NNNN.pvtu and its pieces (NNNN is the step): the slave faces of all pairs at
  /// reference positions, with `displacement`, `traction` (force on the slave per area), `pressure`
  /// (positive in compression), `gap` (NaN where no master surface was found), `status` (1 active,
  /// 0 not, 2 alternating), and `pair` (a number from 0, with its name in the field data
  /// `pair_names`). A face of two pairs occurs twice. Throws OutputError. Collective.
  /// @param snapshot the solution
  /// @param directory in which files are written
  /// @param name of the files
  /// @return the name of the record NAME_NNNN.pvtu
  template <int dim>
  std::string
  write_contact(const Snapshot<dim> &snapshot,
                const std::string   &directory,
                const std::string   &name = "contact");
} // namespace Signorini
