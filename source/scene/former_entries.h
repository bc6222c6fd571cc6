// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// An entry of results.json that had another name in the last release.
  struct FormerEntry
  {
    /// Path of the object that contains it; `*` stands for any part of a path.
    std::string parent;
    std::string former, now;
  };

  /// @return all entries that were renamed.
  const std::vector<FormerEntry> &
  former_entries();

  /// @return former and present names of the checks of the verdict that were renamed.
  const std::vector<std::pair<std::string, std::string>> &
  former_checks();

  /// Add each renamed entry under its former name as well, and a list `deprecated` of all names
  /// that the next release removes, with the new ones.
  /// @param results the contents of results.json, which are changed
  void
  add_former_entries(nlohmann::ordered_json &results);

  /// @return a path with present names.
  /// @param path of a number in results.json, or in its last load step, possibly with former names
  /// @param dim 2 or 3
  std::string
  present_path(const std::string &path, unsigned int dim);
} // namespace Signorini
