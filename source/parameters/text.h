#pragma once

#include <signorini/parameters/raw.h>

#include <iosfwd>
#include <string>

namespace Signorini
{
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

  /// Read a scene from a stream; `name` stands for the file in messages.
  RawSection
  read_raw(std::istream &in, const std::string &name);
} // namespace Signorini
