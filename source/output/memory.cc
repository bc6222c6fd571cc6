// SPDX-License-Identifier: Apache-2.0
#include "output/memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace Signorini
{
  double
  available_memory()
  {
    std::ifstream file("/proc/meminfo");
    for (std::string key; file >> key;)
      {
        double value = 0;
        if (key == "MemAvailable:" && file >> value)
          return value;
        file.ignore(1000, '\n');
      }
    return std::numeric_limits<double>::infinity();
  }
} // namespace Signorini
