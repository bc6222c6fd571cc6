// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/section.h>

namespace Signorini
{
  /// @return the memory of this machine in bytes; tests may assign another value.
  double &
  memory_of_machine();

  /// @return the number of cells above which a mesh cannot fit into the memory of this machine.
  double
  largest_number_of_cells();

  /// Throws SceneError if the product of some numbers of coarse cells does not fit into the memory.
  /// @param section of the key
  /// @param key that has the numbers
  /// @param numbers of cells in each direction
  void
  check_number_of_cells(const Section                   &section,
                        const std::string               &key,
                        const std::vector<unsigned int> &numbers);
} // namespace Signorini
