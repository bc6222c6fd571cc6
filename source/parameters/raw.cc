#include <signorini/parameters/raw.h>
#include <signorini/parameters/text.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace Signorini
{
  namespace
  {
    std::string
    readable(std::string message)
    {
      constexpr std::size_t longest = 4000, beginning = 1000;
      if (message.size() > longest)
        message =
          message.substr(0, beginning) + "... (" + std::to_string(message.size()) + " characters)";
      for (char &c : message)
        if (std::iscntrl(static_cast<unsigned char>(c)) && c != '\n' && c != '\t')
          c = '?';
      return message;
    }
  } // namespace



  SceneError::SceneError(const std::string &message)
    : std::runtime_error(readable(message))
  {}



  std::string
  trim(const std::string &text)
  {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
  }



  std::vector<std::string>
  split(const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    if (trim(text).empty())
      return parts;
    for (std::size_t begin = 0; begin <= text.size();)
      {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(trim(text.substr(begin, end - begin)));
        begin = end + 1;
      }
    return parts;
  }



  std::string
  join(const std::vector<std::string> &words, const std::string &separator)
  {
    std::string text;
    for (const std::string &word : words)
      text += (text.empty() ? "" : separator) + word;
    return text;
  }



  std::string
  shortened(const std::string &text)
  {
    constexpr std::size_t longest = 200, beginning = 80;
    if (text.size() <= longest)
      return text;
    return text.substr(0, beginning) + "... (" + std::to_string(text.size()) + " characters)";
  }



  namespace
  {
    std::string
    lower(std::string word)
    {
      std::transform(word.begin(), word.end(), word.begin(), ::tolower);
      return word;
    }

    /// Levenshtein distance.
    unsigned int
    distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          unsigned int diagonal = row[0];
          row[0]                = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              const unsigned int substituted = diagonal + (a[i - 1] != b[j - 1]);
              diagonal                       = row[j];
              row[j]                         = std::min({substituted, row[j] + 1, row[j - 1] + 1});
            }
        }
      return row.back();
    }

    /// A line without its comment; several lines where `\` continues them.
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

    std::pair<std::string, std::string>
    split_assignment(const std::string &text, const std::string &where)
    {
      const auto equals = text.find('=');
      if (equals == std::string::npos)
        throw SceneError(where + ": expected KEY = VALUE, found '" + shortened(text) + "'");
      return {trim(text.substr(0, equals)), trim(text.substr(equals + 1))};
    }

    /// No scene has so many; what calls itself for each would run out of stack.
    void
    refuse_depth(const std::size_t depth, const std::string &where)
    {
      constexpr std::size_t deepest = 100;
      if (depth > deepest)
        throw SceneError(where + ": subsections are nested more than " + std::to_string(deepest) +
                         " deep; is an end missing?");
    }

    class Reader
    {
    public:
      Reader(std::istream &in, const std::string &file_name)
        : file_name(file_name)
        , in(in)
      {
        skip_byte_order_mark(in);
      }

      void
      read(RawSection &section, const bool top)
      {
        refuse_depth(++depth, where());
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
      std::string
      where() const
      {
        return file_name + ":" + std::to_string(number);
      }

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
      std::size_t       depth  = 0; ///< of sections within each other
    };
  } // namespace



  std::string
  nearest(const std::string &word, const std::vector<std::string> &candidates)
  {
    std::string best;
    if (word.size() > 200)
      return best;
    unsigned int best_distance = word.size() / 2 + 1;
    for (const std::string &candidate : candidates)
      if (const auto d = distance(lower(word), lower(candidate)); d < best_distance)
        {
          best_distance = d;
          best          = candidate;
        }
    // A word of a longer name is a good guess too.
    if (best.empty() && word.size() > 2)
      for (const std::string &candidate : candidates)
        if (lower(candidate).find(lower(word)) != std::string::npos)
          return candidate;
    return best;
  }



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



  std::string
  short_text(const double value, const int digits)
  {
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
  }



  bool
  is_directory(const std::string &name)
  {
    std::error_code is_no_name;
    return std::filesystem::is_directory(name, is_no_name);
  }



  void
  skip_byte_order_mark(std::istream &in)
  {
    for (const int byte : {0xEF, 0xBB, 0xBF})
      if (in.peek() == byte)
        in.get();
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
    refuse_depth(parts.size(), where);
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
