// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// A feature of an imported deck that its scene does not contain.
  struct SkippedItem
  {
    /// "load", "support", "motion", "pair" and "body" are features that act on bodies or support
    /// them, "material" influences their stiffness, and "keyword" may be any of these; "model" is a
    /// feature that the program does not model, such as friction.
    std::string kind;
    /// Description, with positions in the deck.
    std::string what;

    /// @return whether the solution may be entirely different without it.
    bool
    acts() const
    {
      return kind != "model";
    }
  };

  /// @return the items of a list "KIND: what; KIND: what". Throws SceneError for an unknown kind.
  /// @param list the text
  std::vector<SkippedItem>
  skipped_in(const std::string &list);
} // namespace Signorini
