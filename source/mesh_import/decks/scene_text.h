// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/decks/history_groups.h"

namespace Signorini
{
  /// A number with all digits that a deck may have.
  std::string
  long_text(double x, unsigned int digits = 12);

  /// Times may be as close as the two sides of a jump.
  std::string
  text_of_time(double t);

  /// A list of subsections with their names; nothing if there are none.
  std::string
  section(const std::string &title, const std::vector<SceneItem> &items);
} // namespace Signorini
