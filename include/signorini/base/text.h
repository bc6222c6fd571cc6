// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace Signorini
{
  /// @return the candidate whose spelling is closest to a word; empty if none is close.
  /// @param word any word
  /// @param candidates possible words
  std::string
  nearest(const std::string &word, const std::vector<std::string> &candidates);

  /// @return words as a text, "a, b, c".
  /// @param words any number
  /// @param separator between them
  std::string
  join(const std::vector<std::string> &words, const std::string &separator = ", ");

  /// @return the trimmed parts of a text; none if it is empty.
  /// @param text any text
  /// @param separator between the parts
  std::vector<std::string>
  split(const std::string &text, char separator);

  /// @return a text without blanks, tabs and carriage returns at both ends.
  /// @param text any text
  std::string
  trim(const std::string &text);

  /// @return a text for messages; long ones are replaced by their beginning and length.
  /// @param text any text
  std::string
  shortened(const std::string &text);

  /// @return a number with a few digits, for messages.
  /// @param value the number
  /// @param digits significant ones
  std::string
  short_text(double value, int digits = 2);

  /// @return whether a name is that of a directory; false also for names that no file can have.
  /// Streams open directories without error, and fail when they read.
  /// @param name path
  bool
  is_directory(const std::string &name);

  /// Skip the byte order mark, three bytes by which some editors mark a file as UTF-8.
  /// @param in a stream at its beginning
  void
  skip_byte_order_mark(std::istream &in);
} // namespace Signorini
