// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// Something that a deck has and its scene has not.
  struct SkippedItem
  {
    /// "load", "support", "motion", "pair" and "body" are of what acts on bodies, or bears them,
    /// "material" is of what resists, and "keyword" may be any of these; "model" is what this
    /// program does without, as friction.
    std::string kind;
    std::string what; ///< with its places in the deck

    /// Without it the solution may be another one altogether.
    bool
    acts() const
    {
      return kind != "model";
    }
  };

  /// The list "KIND: what; KIND: what". Throws SceneError for another kind.
  std::vector<SkippedItem>
  skipped_in(const std::string &list);
} // namespace Signorini
