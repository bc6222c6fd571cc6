#pragma once

#include <string>

namespace Signorini
{
  /// Replaces table(x, x1, y1, x2, y2, ...) in a formula, which is linear between the points and
  /// constant beyond them, by what the formula's parser knows. x may be any formula, all others are
  /// numbers, x1 < x2 < ... Throws SceneError.
  std::string
  expand_tables(const std::string &formula);
} // namespace Signorini
