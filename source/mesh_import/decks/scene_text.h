// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/history_groups.h"

namespace Signorini
{
  /// @return a number as text, with all digits that a deck usually has.
  /// @param x the number
  /// @param digits significant ones
  std::string
  long_text(double x, unsigned int digits = 12);

  /// @return a time as text, with enough digits to distinguish the two sides of a jump.
  /// @param t the time
  std::string
  text_of_time(double t);

  /// @return a section of a scene with the names of its items and their subsections; empty if there
  /// are no items.
  /// @param title of the section
  /// @param items its subsections
  std::string
  section(const std::string &title, const std::vector<SceneItem> &items);
} // namespace Signorini
