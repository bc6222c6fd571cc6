// SPDX-License-Identifier: Apache-2.0
#include "parameters/values.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <type_traits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return whether values of a type may have been given by formulas, which are worth keeping
    /// when the scene is written.
    template <typename T>
    constexpr bool
    is_number(const T &)
    {
      return !(std::is_same_v<T, bool> || std::is_same_v<T, std::string> ||
               std::is_same_v<T, std::vector<std::string>>);
    }

    /// Throw SceneError if a value is not in a range; values without order are always accepted.
    template <typename T>
    void
    check_range(const T &, const Range &)
    {}

    void
    check_range(const double value, const Range &range)
    {
      if (!range.contains(value))
        throw SceneError("must be " + range.text());
    }

    void
    check_range(const unsigned int value, const Range &range)
    {
      check_range(static_cast<double>(value), range);
    }

    void
    check_range(const std::vector<double> &values, const Range &range)
    {
      for (const double value : values)
        check_range(value, range);
    }

    void
    check_range(const std::vector<unsigned int> &values, const Range &range)
    {
      for (const unsigned int value : values)
        check_range(value, range);
    }

    /// @return a hint for messages, such as "; did you mean 'X'? Valid here: A, B.".
    std::string
    hint(const std::string &word, const std::vector<std::string> &valid)
    {
      const std::string close = nearest(word, valid);
      return (close.empty() ? "." : "; did you mean '" + close + "'?") +
             (valid.empty() ? "" : " Valid here: " + join(valid) + ".");
    }
  } // namespace



  bool
  Range::contains(const double x) const
  {
    return (low_is_allowed ? x >= low : x > low) && (high_is_allowed ? x <= high : x < high);
  }



  std::string
  Range::text() const
  {
    std::vector<std::string> parts;
    if (std::isfinite(low))
      parts.push_back((low_is_allowed ? ">= " : "> ") + number_text(low));
    if (std::isfinite(high))
      parts.push_back((high_is_allowed ? "<= " : "< ") + number_text(high));
    return join(parts, " and ");
  }



  Section::Section(RawSection &raw, const std::string &path)
    : raw(&raw)
    , my_path(path)
  {
    raw.used = true;
  }



  Section::Section(std::ostream      &out,
                   const bool         comments,
                   const unsigned int indentation,
                   const RawSection  *given)
    : out(&out)
    , given(given)
    , comments(comments)
    , indentation(indentation)
  {}



  // One function for all three uses: describe, write, or read a key. Errors of reading are
  // completed by key, position and help text.
  template <typename T>
  void
  Section::add(const std::string &key, T &value, const std::string &help, const Range &range)
  {
    if (description)
      return description->keys.push_back(
        {key, type_name(value), to_text(value), help, range.text(), {}, false});
    if (!reading())
      return write(key, is_number(value) ? as_given(key, to_text(value)) : to_text(value), help);
    known_keys.push_back(key);
    if (RawSection::Value *entry = raw->find_value(key))
      {
        entry->used = true;
        try
          {
            from_text(Formula(entry->text, definitions), value);
            check_range(value, range);
          }
        catch (const SceneError &error)
          {
            fail(key, std::string(error.what()) + " (" + help + ")");
          }
      }
  }



  template <typename T>
  std::string
  Section::text_of(const T &value)
  {
    return to_text(value);
  }



  void
  Section::add_choice(const std::string              &key,
                      std::string                    &value,
                      const std::vector<std::string> &choices,
                      const std::string              &help)
  {
    if (description)
      {
        description->keys.push_back({key, "", value, help, "", choices, false});
        return;
      }
    add(key, value, help + ": " + join(choices, " | "));
    if (reading() && std::find(choices.begin(), choices.end(), value) == choices.end())
      fail(key, "is not one of the choices" + hint(value, choices));
  }



  // The definitions become available to all keys that are added later.
  void
  Section::add_definitions(const std::string &name, Definitions &value, const std::string &help)
  {
    add_section(name, help, [&](Section &section) {
      if (description)
        return;
      if (!reading())
        {
          for (const auto &[key, formula] : value.all())
            section.write(key, formula, "");
          return;
        }
      for (RawSection::Value &entry : section.raw->values)
        {
          entry.used = true;
          try
            {
              value.add(entry.key, entry.text);
            }
          catch (const SceneError &error)
            {
              section.fail(entry.key, error.what());
            }
        }
    });
    definitions = std::make_shared<Definitions>(value);
  }



  bool
  Section::defines(const std::string &name) const
  {
    return definitions->is_defined(name);
  }



  std::string
  Section::source_of(const std::string &key) const
  {
    const RawSection::Value *entry = raw ? raw->find_value(key) : nullptr;
    if (entry)
      return entry->where + ": " + path_of(key) + " = " + shortened(entry->text);
    return (raw && !raw->where.empty() ? raw->where + ": " : "") + path_of(key) + " (not set)";
  }



  void
  Section::fail(const std::string &key, const std::string &what) const
  {
    // A required key that is missing may have been misspelt: then the unknown key is reported
    // instead.
    if (raw && !is_set(key))
      for (const RawSection::Value &value : raw->values)
        if (!value.used && nearest(value.key, {key}) == key)
          throw SceneError(value.where + ": unknown key '" + path_of(shortened(value.key)) +
                           "' = '" + shortened(value.text) + "'" + hint(value.key, {key}));
    throw SceneError(source_of(key) + ": " + what);
  }



  // Keys and sections that no declare() has asked for are errors. Items whose names the command
  // line has replaced are exempt.
  void
  Section::close()
  {
    for (const RawSection::Value &value : raw->values)
      if (!value.used)
        throw SceneError(value.where + ": unknown key '" + path_of(shortened(value.key)) + "' = '" +
                         shortened(value.text) + "'" + hint(value.key, known_keys));
    const RawSection::Value *names     = raw->find_value("Names");
    const bool               is_list   = names && names->used;
    const bool               is_chosen = is_list && is_override(names->where);
    for (const RawSection &section : raw->sections)
      if (!section.used && !is_chosen) // names replaced on the command line are exempt
        throw SceneError(section.where + ": unknown subsection '" +
                         path_of(shortened(section.name)) + "'" +
                         (is_list ? ", which is not among the Names there" : "") +
                         hint(section.name, known_sections));
  }



  std::string
  Section::path_of(const std::string &name) const
  {
    return my_path.empty() ? name : my_path + "/" + name;
  }



  RawSection *
  Section::open(const std::string &name)
  {
    known_sections.push_back(name);
    return raw->find_section(name);
  }



  // Write the beginning of a subsection.
  Section
  Section::begin(const std::string &name, const std::string &help)
  {
    const std::string indent(2 * indentation, ' ');
    if (comments && !help.empty())
      *out << '\n' << indent << "# " << help << '\n';
    *out << indent << "subsection " << name << '\n';
    return Section(*out, comments, indentation + 1, given ? given->find_section(name) : nullptr);
  }



  void
  Section::end()
  {
    *out << std::string(2 * indentation, ' ') << "end\n";
  }



  // Names of items must not contain separators, and must be unique.
  void
  Section::check_names(const std::vector<std::string> &names) const
  {
    std::set<std::string> seen;
    for (const std::string &name : names)
      {
        if (name.empty() || name.find_first_of("./=;:") != std::string::npos)
          fail("Names",
               "'" + name + "' is not a name: it must not be empty or contain any of . / = ; :");
        if (!seen.insert(name).second)
          fail("Names", "'" + name + "' is there twice");
      }
  }



  // Numbers are written as the formulas by which the user has given them.
  std::string
  Section::as_given(const std::string &key, const std::string &otherwise) const
  {
    const RawSection::Value *entry = given ? given->find_value(key) : nullptr;
    return entry ? entry->text : otherwise;
  }



  void
  Section::write(const std::string &key, const std::string &value, const std::string &help)
  {
    const std::string assignment = std::string(2 * indentation, ' ') + "set " + key + " = " + value;
    *out << assignment;
    if (comments && !help.empty())
      *out << std::string(assignment.size() < 44 ? 44 - assignment.size() : 1, ' ') << "# " << help;
    *out << '\n';
  }



#define INSTANTIATE(T)                                                                             \
  template void        Section::add(const std::string &, T &, const std::string &, const Range &); \
  template std::string Section::text_of(const T &);
  INSTANTIATE(double)
  INSTANTIATE(unsigned int)
  INSTANTIATE(bool)
  INSTANTIATE(std::string)
  INSTANTIATE(Formula)
  INSTANTIATE(std::vector<std::string>)
  INSTANTIATE(std::vector<double>)
  INSTANTIATE(std::vector<unsigned int>)
  INSTANTIATE(Point<2>)
  INSTANTIATE(std::vector<Point<2>>)
  INSTANTIATE(std::vector<Point<3>>)
  INSTANTIATE(Point<3>)
  INSTANTIATE(Expression<2>)
  INSTANTIATE(Expression<3>)
  INSTANTIATE(VectorExpression<2>)
  using OneComponent = VectorExpression<2, 1>;
  INSTANTIATE(OneComponent)
  INSTANTIATE(VectorExpression<3>)
#undef INSTANTIATE
} // namespace Signorini
