// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/section.h>

namespace Signorini
{
  /// What memory there is, in bytes: that of this machine, unless another number is written here.
  double &
  memory_of_machine();

  /// More cells than that do not fit into the memory of this machine, whatever is done with them.
  double
  largest_number_of_cells();

  /// Refuse a number of coarse cells, given by a key, that no memory holds. The product of
  /// `numbers` counts.
  void
  check_number_of_cells(const Section                   &section,
                        const std::string               &key,
                        const std::vector<unsigned int> &numbers);
} // namespace Signorini
