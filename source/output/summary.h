// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>

namespace Signorini
{
  /// Print the main results of a run: contact of each pair at the last load step, forces, and
  /// times.
  /// @param results the contents of results.json
  /// @param out the stream
  void
  print_summary(const nlohmann::ordered_json &results, std::ostream &out);
} // namespace Signorini
