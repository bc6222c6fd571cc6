// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// The candidate that is spelt most like the given word, or an empty string if none is close.
  std::string
  nearest(const std::string &word, const std::vector<std::string> &candidates);

  /// "a, b, c"
  std::string
  join(const std::vector<std::string> &words, const std::string &separator = ", ");

  /// Split at the separator and trim; an empty text has no parts.
  std::vector<std::string>
  split(const std::string &text, char separator);

  std::string
  trim(const std::string &text);

  /// For messages: a long text by its beginning and its length.
  std::string
  shortened(const std::string &text);

  /// For messages: a number with a few digits.
  std::string
  short_text(double value, int digits = 2);

  /// False also for names that no file can have. Streams open directories, and fail when they read.
  bool
  is_directory(const std::string &name);

  /// Three bytes at the start by which some editors say that a file is UTF-8.
  void
  skip_byte_order_mark(std::istream &in);
} // namespace Signorini
