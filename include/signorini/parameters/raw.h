// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <deque>
#include <iosfwd>
#include <string>

namespace Signorini
{
  /// A scene file as it was written: sections and values with the place where each was set, not yet
  /// interpreted. Syntax: `subsection NAME`, `set KEY = VALUE`, `end`, comments after `#`, a
  /// trailing
  /// `\` continues a line.
  struct RawSection
  {
    struct Value
    {
      std::string key, text, where;
      bool        used = false;
    };

    std::string name, where;
    bool        used = false;
    // Deques, so that references to elements survive the addition of others.
    std::deque<Value>      values;
    std::deque<RawSection> sections;

    Value *
    find_value(const std::string &key);
    const Value *
    find_value(const std::string &key) const;
    RawSection *
    find_section(const std::string &name);
    const RawSection *
    find_section(const std::string &name) const;
    RawSection &
    get_section(const std::string &name, const std::string &where);
    void
    set_value(const std::string &key, const std::string &text, const std::string &where);
  };

  /// Read a scene file. Throws SceneError with file and line on a syntax error or a key set twice.
  RawSection
  read_raw(const std::string &file_name);

  /// Apply one command line override `Section/Subsection/Key=value`.
  void
  override_value(RawSection &root, const std::string &assignment);

  /// Read a scene from a stream; `name` stands for the file in messages.
  RawSection
  read_raw(std::istream &in, const std::string &name);

  /// True if a value or section comes from the command line, by its `where`.
  bool
  is_override(const std::string &where);
} // namespace Signorini
