// SPDX-License-Identifier: Apache-2.0
#include "scene/skipped_items.h"

#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  // Each item is KIND: text.
  std::vector<SkippedItem>
  skipped_in(const std::string &list)
  {
    static const std::vector<std::string> kinds{
      "load", "support", "motion", "pair", "body", "material", "keyword", "model"};
    std::vector<SkippedItem> result;
    for (const std::string &one : split(list, ';'))
      {
        const auto        colon = one.find(':');
        const std::string kind  = one.substr(0, colon);
        if (colon == std::string::npos ||
            std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
          throw SceneError("Not imported = ... " + one + ": each part begins with one of " +
                           join(kinds) + ", and a colon");
        result.push_back({kind, trim(one.substr(colon + 1))});
      }
    return result;
  }
} // namespace Signorini
