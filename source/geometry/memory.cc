// SPDX-License-Identifier: Apache-2.0
#include "geometry/memory.h"

#include <unistd.h>

#include <sstream>

namespace Signorini
{
  double &
  memory_of_machine()
  {
    static double bytes = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
    return bytes;
  }



  // A lower bound of the memory of a cell, so that no feasible mesh is rejected.
  double
  largest_number_of_cells()
  {
    constexpr double bytes = 400; // of a cell, by deal.II's triangulations alone
    return memory_of_machine() / bytes;
  }



  void
  check_number_of_cells(const Section                   &section,
                        const std::string               &key,
                        const std::vector<unsigned int> &numbers)
  {
    double product = 1;
    for (const unsigned int n : numbers)
      product *= n;
    if (product <= largest_number_of_cells())
      return;
    std::ostringstream text;
    text << "asks for " << product << " cells, more than the " << largest_number_of_cells()
         << " that fit into the memory of this machine; use fewer";
    section.fail(key, text.str());
  }
} // namespace Signorini
