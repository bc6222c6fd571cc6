// SPDX-License-Identifier: Apache-2.0
#include "mesh/generators/circle_part.h"

#include <utility>

namespace Signorini
{
  namespace
  {
    const std::vector<std::pair<std::string, CirclePart>> parts = {
      {"full", {0, 4}},
      {"upper half", {0, 2}},
      {"left half", {1, 2}},
      {"lower half", {2, 2}},
      {"right half", {3, 2}},
      {"upper right quarter", {0, 1}},
      {"upper left quarter", {1, 1}},
      {"lower left quarter", {2, 1}},
      {"lower right quarter", {3, 1}},
      // Short names of the two that are used most.
      {"half", {0, 2}},
      {"quarter", {0, 1}}};
  } // namespace



  std::vector<std::string>
  circle_part_names()
  {
    std::vector<std::string> names;
    for (const auto &part : parts)
      names.push_back(part.first);
    return names;
  }



  CirclePart
  circle_part(const std::string &name)
  {
    for (const auto &part : parts)
      if (part.first == name)
        return part.second;
    return {};
  }
} // namespace Signorini
