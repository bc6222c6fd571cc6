// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <deque>
#include <iosfwd>
#include <string>

namespace Signorini
{
  /// A section of a scene file as it was written, with the position of each value, not yet
  /// interpreted. Syntax: `subsection NAME`, `set KEY = VALUE`, `end`, comments after `#`, a
  /// trailing `\` continues a line.
  struct RawSection
  {
    /// The text of a key.
    struct Value
    {
      std::string key, text, where;
      bool        used = false;
    };

    /// Name of the section, and position FILE:LINE of its first occurrence.
    std::string name, where;
    bool        used = false;
    // Deques, so that references to elements remain valid when others are added.
    std::deque<Value>      values;
    std::deque<RawSection> sections;

    /// @return the value of a key; null if it is not set.
    /// @param key the key
    Value *
    find_value(const std::string &key);
    const Value *
    find_value(const std::string &key) const;
    /// @return a subsection; null if there is none.
    /// @param name of the subsection
    RawSection *
    find_section(const std::string &name);
    const RawSection *
    find_section(const std::string &name) const;
    /// @return a subsection, which is created if there is none.
    /// @param name of the subsection
    /// @param where its position, if it is created
    RawSection &
    get_section(const std::string &name, const std::string &where);
    /// Set a key, which replaces a former value.
    /// @param key the key
    /// @param text its value
    /// @param where its position
    void
    set_value(const std::string &key, const std::string &text, const std::string &where);
  };

  /// Read a scene file. Throws SceneError with file and line for a syntax error or a key that is
  /// set twice.
  /// @param file_name path of the file
  /// @return the contents
  RawSection
  read_raw(const std::string &file_name);

  /// Apply an override of the command line. Throws SceneError if it has another form.
  /// @param root the scene, which is changed
  /// @param assignment `Section/Subsection/Key=value`
  void
  override_value(RawSection &root, const std::string &assignment);

  /// Read a scene from a stream. Throws SceneError as for files.
  /// @param in the stream
  /// @param name of the file in messages
  /// @return the contents
  RawSection
  read_raw(std::istream &in, const std::string &name);

  /// @return whether a value or section comes from the command line.
  /// @param where its position
  bool
  is_override(const std::string &where);
} // namespace Signorini
