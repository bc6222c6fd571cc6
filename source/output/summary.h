// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>

namespace Signorini
{
  /// The main figures of a run, for a person: contact of each pair at the last load step, forces,
  /// where the time went.
  void
  print_summary(const nlohmann::ordered_json &results, std::ostream &out);
} // namespace Signorini
