// SPDX-License-Identifier: Apache-2.0
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <filesystem>
#include <fstream>

namespace Signorini
{
  namespace
  {
    /// Read the next logical line, without comment; several physical lines if `\` continues them.
    /// @return false at the end of the file
    bool
    next_line(std::istream &in, std::string &line, unsigned int &number)
    {
      line.clear();
      std::string part;
      while (std::getline(in, part))
        {
          ++number;
          part            = trim(part.substr(0, part.find('#')));
          const bool more = !part.empty() && part.back() == '\\';
          line += more ? part.substr(0, part.size() - 1) : part;
          if (!more)
            return true;
        }
      return !line.empty();
    }

    /// @return key and value of "KEY = VALUE". Throws SceneError.
    std::pair<std::string, std::string>
    split_assignment(const std::string &text, const std::string &where)
    {
      const auto equals = text.find('=');
      if (equals == std::string::npos)
        throw SceneError(where + ": expected KEY = VALUE, found '" + shortened(text) + "'");
      return {trim(text.substr(0, equals)), trim(text.substr(equals + 1))};
    }

    /// Throw SceneError if sections are nested so deeply that recursion over them would exhaust the
    /// stack.
    void
    reject_depth(const std::size_t depth, const std::string &where)
    {
      constexpr std::size_t deepest = 100;
      if (depth > deepest)
        throw SceneError(where + ": subsections are nested more than " + std::to_string(deepest) +
                         " deep; is an end missing?");
    }

    /// Recursive-descent reader of scene files, which counts lines for messages.
    class Reader
    {
    public:
      Reader(std::istream &in, const std::string &file_name)
        : file_name(file_name)
        , in(in)
      {
        skip_byte_order_mark(in);
      }

      /// Read statements up to the `end` of a section, or to the end of the file at the top level.
      void
      read(RawSection &section, const bool top)
      {
        reject_depth(++depth, where());
        std::string line;
        while (next_line(in, line, number))
          if (line.empty())
            continue;
          else if (line == "end" && !top)
            {
              --depth;
              return;
            }
          else
            statement(section, line);
        if (!top)
          throw SceneError(section.where + ": subsection '" + section.name + "' has no end");
      }

    private:
      /// @return the present position FILE:LINE.
      std::string
      where() const
      {
        return file_name + ":" + std::to_string(number);
      }

      /// Interpret one line. Throws SceneError.
      void
      statement(RawSection &section, const std::string &line)
      {
        const auto        space = line.find_first_of(" \t");
        const std::string word  = line.substr(0, space);
        const std::string rest  = space == std::string::npos ? "" : trim(line.substr(space));
        if (word == "subsection" && !rest.empty())
          read(section.get_section(rest, where()), false);
        else if (word == "set")
          {
            const auto [key, value] = split_assignment(rest, where());
            if (RawSection::Value *old = section.find_value(key))
              throw SceneError(where() + ": '" + key + "' is already set at " + old->where);
            section.set_value(key, value, where());
          }
        else
          throw SceneError(where() +
                           ": expected 'set KEY = VALUE', 'subsection NAME' or 'end', found '" +
                           shortened(line) + "'");
      }

      const std::string file_name;
      std::istream     &in;
      unsigned int      number = 0;
      /// Number of sections in which the present line is nested.
      std::size_t depth = 0;
    };
  } // namespace



  RawSection::Value *
  RawSection::find_value(const std::string &key)
  {
    for (Value &value : values)
      if (value.key == key)
        return &value;
    return nullptr;
  }



  const RawSection::Value *
  RawSection::find_value(const std::string &key) const
  {
    return const_cast<RawSection *>(this)->find_value(key);
  }



  const RawSection *
  RawSection::find_section(const std::string &name) const
  {
    return const_cast<RawSection *>(this)->find_section(name);
  }



  RawSection *
  RawSection::find_section(const std::string &wanted)
  {
    for (RawSection &section : sections)
      if (section.name == wanted)
        return &section;
    return nullptr;
  }



  RawSection &
  RawSection::get_section(const std::string &wanted, const std::string &place)
  {
    if (RawSection *section = find_section(wanted))
      return *section;
    sections.emplace_back();
    sections.back().name  = wanted;
    sections.back().where = place;
    return sections.back();
  }



  void
  RawSection::set_value(const std::string &key, const std::string &text, const std::string &place)
  {
    if (Value *value = find_value(key))
      *value = {key, text, place};
    else
      values.push_back({key, text, place});
  }



  RawSection
  read_raw(std::istream &in, const std::string &name)
  {
    RawSection root;
    Reader(in, name).read(root, true);
    return root;
  }



  RawSection
  read_raw(const std::string &file_name)
  {
    if (is_directory(file_name))
      throw SceneError("'" + file_name + "' is a directory, not a scene file; name a file in it");
    std::ifstream in(file_name);
    if (!in)
      throw SceneError("cannot open the scene file '" + file_name + "'");
    return read_raw(in, file_name);
  }



  void
  override_value(RawSection &root, const std::string &assignment)
  {
    const std::string where        = "--set \"" + shortened(assignment) + "\"";
    const auto [path, value]       = split_assignment(assignment, where);
    std::vector<std::string> parts = split(path, '/');
    if (parts.empty() || parts.back().empty())
      throw SceneError(where + ": expected SECTION/KEY=VALUE");
    reject_depth(parts.size(), where);
    RawSection *section = &root;
    for (unsigned int i = 0; i + 1 < parts.size(); ++i)
      section = &section->get_section(parts[i], where);
    section->set_value(parts.back(), value, where);
  }



  bool
  is_override(const std::string &where)
  {
    return where.find("--set") == 0;
  }
} // namespace Signorini
