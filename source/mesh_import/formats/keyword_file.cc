// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/keyword_file.h"

#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/section.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace Signorini
{
  namespace
  {
    constexpr unsigned int deepest_include = 20; // a file that includes itself ends here

    const std::string byte_order_mark = "\xEF\xBB\xBF"; // which Windows puts before UTF-8

    bool
    starts_with(const std::string &text, const std::string &start)
    {
      return text.compare(0, start.size(), start) == 0;
    }



    /// @return the trimmed words between commas that are not in quotes.
    std::vector<std::string>
    split_at_commas(const std::string &text)
    {
      std::vector<std::string> words;
      bool                     is_quoted = false;
      std::size_t              start     = 0;
      for (std::size_t i = 0; i <= text.size(); ++i)
        if (i == text.size() || (text[i] == ',' && !is_quoted))
          {
            words.push_back(trim(text.substr(start, i - start)));
            start = i + 1;
          }
        else
          is_quoted ^= text[i] == '"';
      return words;
    }



    /// @return a text without quotes and outer blanks.
    std::string
    without_quotes(std::string text)
    {
      text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
      return trim(text);
    }



    /// @return a text with single blanks between words, since NODE   PRINT and NODE PRINT are the
    /// same keyword.
    std::string
    with_single_blanks(const std::string &text)
    {
      std::string result;
      for (const std::string &word : split(text, ' '))
        if (!word.empty())
          result += (result.empty() ? "" : " ") + word;
      return result;
    }
  } // namespace



  bool
  IgnoringBlanks::operator()(const std::string &a, const std::string &b) const
  {
    auto i = a.begin(), j = b.begin();
    while (true)
      {
        i = std::find_if(i, a.end(), [](const char c) { return c != ' '; });
        j = std::find_if(j, b.end(), [](const char c) { return c != ' '; });
        if (i == a.end() || j == b.end())
          return j != b.end();
        if (*i != *j)
          return *i < *j;
        ++i, ++j;
      }
  }



  std::string
  upper_case(std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char c) {
      return std::toupper(c);
    });
    return text;
  }



  KeywordFile::KeywordFile(const std::string &file_name)
    : name(file_name)
  {
    open(file_name);
  }



  // Files are a stack, of which the last one is read. A limit of its depth ends files that include
  // themselves.
  void
  KeywordFile::open(const std::string &file_name)
  {
    if (sources.size() > deepest_include)
      fail("files include each other more than " + std::to_string(deepest_include) +
           " deep; does '" + file_name + "' include itself?");
    if (is_directory(file_name))
      fail("'" + file_name + "' is a directory, not a file");
    auto in = std::make_unique<std::ifstream>(file_name);
    if (!*in)
      fail("the file '" + file_name + "' cannot be opened");
    skip_byte_order_mark(*in);
    sources.push_back({file_name, std::move(in), 0});
  }



  // The next line that is neither empty nor a comment, with blanks for tabs and numbers for
  // <names>; of the including file where an included one ends.
  bool
  KeywordFile::next_text(std::string &line)
  {
    while (!sources.empty())
      {
        Source &source = sources.back();
        if (!std::getline(*source.in, line))
          {
            sources.pop_back();
            continue;
          }
        name        = source.name;
        line_number = ++source.line;
        std::replace_if(
          line.begin(), line.end(), [](const char c) { return c == '\t' || c == '\r'; }, ' ');
        line = trim(starts_with(line, byte_order_mark) ? line.substr(3) : line);
        if (line.empty() || starts_with(line, "**"))
          continue;
        line = evaluated(line);
        return true;
      }
    return false;
  }



  // `pending` is a keyword line that has been read while data lines were expected. *INCLUDE and
  // *PARAMETER are processed here and not returned.
  bool
  KeywordFile::next_keyword()
  {
    std::string line = std::move(pending);
    pending.clear();
    while (line.empty() || line[0] != '*')
      if (!next_text(line))
        return false;
    if (follow_include(line))
      return next_keyword();
    parse_keyword(line);
    if (my_keyword != "PARAMETER")
      return true;
    read_parameters();
    return next_keyword();
  }



  // Data lines of *INCLUDE belong to the keyword before it.
  bool
  KeywordFile::follow_include(const std::string &line)
  {
    if (upper_case(split_at_commas(line)[0]) != "*INCLUDE")
      return false;
    // An *INCLUDE among data lines continues these lines: the present keyword is restored
    // afterwards.
    const auto keyword = my_keyword;
    const auto others  = parameters;
    parse_keyword(line);
    if (value("INPUT").empty())
      fail("*INCLUDE needs INPUT=file");
    open_beside(value("INPUT"));
    data_file.clear();
    my_keyword = keyword;
    parameters = others;
    return true;
  }



  // Each data line is "name = formula" with ** for powers; # begins a comment. The definitions are
  // copied, so that formulas that are in use keep theirs.
  void
  KeywordFile::read_parameters()
  {
    if (!parameters.empty())
      fail("*PARAMETER, " + parameters.begin()->first +
           " is not read here; write out the numbers, or each as name = formula");
    auto all = std::make_shared<Definitions>(numbers ? *numbers : Definitions());
    for (std::string line; next_text(line);)
      {
        if (line[0] == '*')
          {
            pending = line;
            break;
          }
        line             = trim(line.substr(0, line.find('#')));
        const auto equal = line.find('=');
        if (line.empty())
          continue;
        try
          {
            if (equal == std::string::npos)
              throw SceneError("is not name = formula");
            // ** is the power operator of Python, ^ that of formulas here.
            std::string formula = trim(line.substr(equal + 1));
            for (auto power = formula.find("**"); power != std::string::npos;
                 power      = formula.find("**"))
              formula.replace(power, 2, "^");
            double value;
            from_text(Formula(formula, all), value);
            all->add(trim(line.substr(0, equal)), formula);
          }
        catch (const SceneError &error)
          {
            fail("*PARAMETER: '" + line + "' " + error.what());
          }
      }
    numbers = all;
  }



  // Each <name> is replaced by its value with 16 digits.
  std::string
  KeywordFile::evaluated(std::string line) const
  {
    if (numbers)
      for (const auto &[name, formula] : numbers->all())
        for (auto at = line.find("<" + name + ">"); at != std::string::npos;
             at      = line.find("<" + name + ">"))
          {
                 double value;
                 from_text(Formula(name, numbers), value);
                 line.replace(at, name.size() + 2, short_text(value, 16));
          }
    return line;
  }



  void
  KeywordFile::open_beside(const std::string &file_name)
  {
    open((std::filesystem::path(name).parent_path() / file_name).string());
  }



  // "*KEYWORD, NAME=value, FLAG": a line that ends with a comma continues.
  void
  KeywordFile::parse_keyword(std::string line)
  {
    for (std::string more; line.back() == ',' && next_text(more);)
      line += more;
    const std::vector<std::string> words = split_at_commas(line.substr(1));
    my_keyword                           = upper_case(with_single_blanks(words[0]));
    parameters.clear();
    for (unsigned int i = 1; i < words.size(); ++i)
      {
        if (words[i].empty())
          continue;
        const auto equal = words[i].find('=');
        parameters[upper_case(with_single_blanks(words[i].substr(0, equal)))] =
          equal == std::string::npos ? "" : without_quotes(trim(words[i].substr(equal + 1)));
      }
    data_file = value("INPUT");
  }



  bool
  KeywordFile::has(const std::string &parameter) const
  {
    return parameters.count(parameter) > 0;
  }



  std::string
  KeywordFile::value(const std::string &parameter) const
  {
    const auto found = parameters.find(parameter);
    return found == parameters.end() ? "" : found->second;
  }



  // INPUT=file: the first data lines are those of the other file.
  bool
  KeywordFile::next_line(std::vector<std::string> &words)
  {
    words.clear();
    if (!data_file.empty())
      {
        open_beside(data_file);
        data_file.clear();
      }
    for (std::string line; words.empty();)
      {
        if (!pending.empty() || !next_text(line))
          return false;
        if (line[0] == '*' && follow_include(line))
          continue;
        if (line[0] == '*')
          {
            pending = line;
            return false;
          }
        my_has_continuation = line.back() == ',';
        words = split_at_commas(my_has_continuation ? line.substr(0, line.size() - 1) : line);
        if (line.find('"') != std::string::npos)
          std::transform(words.begin(), words.end(), words.begin(), without_quotes);
      }
    return true;
  }



  void
  KeywordFile::fail(const std::string &what) const
  {
    throw SceneError(position_in_messages() + what);
  }



  std::string
  KeywordFile::position_in_messages() const
  {
    return "mesh file '" + name + "', line " + std::to_string(line_number) + ": ";
  }



  double
  real_from(const KeywordFile &in, const std::string &word)
  {
    std::string text = word;
    std::replace_if(
      text.begin(), text.end(), [](const char c) { return c == 'D' || c == 'd'; }, 'E');
    char        *end   = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    // strtod takes nan, inf and hexadecimal numbers too.
    if (*end != '\0' || text.find_first_not_of("0123456789+-.eE") != std::string::npos ||
        !std::isfinite(value))
      in.fail("'" + word + "' should be a number");
    return value;
  }
} // namespace Signorini
