#pragma once

#include <deque>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /// Something that the user asked for and that cannot be done: a bad scene file, command line or
  /// mesh file. The message names the key, its value, where it was set, and the cure. All ranks
  /// throw it alike, because all ranks read the same input. What files have that nobody can read,
  /// control characters and endless words, is not in it.
  class SceneError : public std::runtime_error
  {
  public:
    explicit SceneError(const std::string &message);
  };

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

  /// True if a value or section comes from the command line, by its `where`.
  bool
  is_override(const std::string &where);

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
} // namespace Signorini
