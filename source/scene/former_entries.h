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
    std::string parent; ///< path of the object that has it; `*` stands for any part of a path
    std::string former, now;
  };

  /// All of them.
  const std::vector<FormerEntry> &
  former_entries();

  /// Names that checks of the verdict had in the last release, and those that they have now.
  const std::vector<std::pair<std::string, std::string>> &
  former_checks();

  /// Each entry under its former name too, and under `deprecated` all names that go with the next
  /// release, with the new ones.
  void
  add_former_entries(nlohmann::ordered_json &results);

  /// The path of a number in results.json, or in its last load step, by present names.
  std::string
  present_path(const std::string &path, unsigned int dim);
} // namespace Signorini
