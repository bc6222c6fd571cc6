// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/definitions.h>

#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// Order of texts in which blanks are ignored: CONTACT PAIR and CONTACTPAIR are the same keyword.
  struct IgnoringBlanks
  {
    bool
    operator()(const std::string &a, const std::string &b) const;
  };

  /// A file of keywords with data lines, in the format of Abaqus and CalculiX:
  ///
  ///     ** comment
  ///     *KEYWORD, PARAMETER=value, PARAMETER
  ///     data, data, data
  ///
  /// Keywords and parameters may be in any case of letters, and with or without blanks. Quoted
  /// texts may contain blanks and commas. A keyword line that ends with a comma continues in the
  /// next line. *INCLUDE, INPUT=file inserts a file, relative to the folder of the including file,
  /// also among data lines; for any other keyword, INPUT=file has the first data lines. *PARAMETER
  /// defines names of numbers by formulas, one `name = formula` on each line, for which `<name>` is
  /// written in all lines that follow.
  class KeywordFile
  {
  public:
    /// Open a file. Throws SceneError if it cannot be opened.
    /// @param file_name its path
    explicit KeywordFile(const std::string &file_name);

    /// Advance to the next keyword, skipping data lines that have not been read.
    /// @return false at the end of the file
    bool
    next_keyword();

    /// @return the present keyword without the star, in upper case, with single blanks.
    const std::string &
    keyword() const
    {
      return my_keyword;
    }

    /// @return whether the keyword line has a parameter, with a value or without.
    /// @param parameter in upper case
    bool
    has(const std::string &parameter) const;

    /// @return the value of a parameter without quotes, in its original case; empty if there is
    /// none.
    /// @param parameter in upper case
    std::string
    value(const std::string &parameter) const;

    /// Read the next data line of this keyword.
    /// @param words the words between its commas, without quotes
    /// @return false if there are no more data lines
    bool
    next_line(std::vector<std::string> &words);

    /// @return all parameters with their values, by names in upper case.
    const std::map<std::string, std::string, IgnoringBlanks> &
    all_parameters() const
    {
      return parameters;
    }

    /// @return "FILE, line LINE" of the present keyword or data line.
    std::string
    current_position() const
    {
      return name + ", line " + std::to_string(line_number);
    }

    /// @return whether the last data line ended with a comma.
    bool
    has_continuation() const
    {
      return my_has_continuation;
    }

    /// @return "mesh file 'FILE', line LINE: ", for messages that are written later.
    std::string
    position_in_messages() const;

    /// Throws SceneError("mesh file 'FILE', line LINE: what").
    /// @param what the message
    [[noreturn]] void
    fail(const std::string &what) const;

  private:
    /// An open file, and how many of its lines have been read.
    struct Source
    {
      std::string                    name;
      std::unique_ptr<std::ifstream> in;
      unsigned int                   line;
    };

    void
    open(const std::string &file_name);
    bool
    next_text(std::string &line);
    void
    open_beside(const std::string &file_name);
    void
    parse_keyword(std::string line);
    /// Open the file of an *INCLUDE.
    /// @return whether the line is one
    bool
    follow_include(const std::string &line);
    void
    read_parameters();
    /// @return the line with numbers for all <names> that *PARAMETER has defined.
    std::string
    evaluated(std::string line) const;

    /// The stack of open files; the last one is being read.
    std::vector<Source> sources;
    std::string         name, my_keyword, pending;
    /// The file of INPUT=, until it is opened.
    std::string                                        data_file;
    unsigned int                                       line_number = 0;
    std::map<std::string, std::string, IgnoringBlanks> parameters;
    /// Definitions of *PARAMETER; null if there are none.
    std::shared_ptr<Definitions> numbers;
    bool                         my_has_continuation = false;
  };

  /// @return a text in upper case (ASCII).
  /// @param text any text
  std::string
  upper_case(std::string text);

  /// @return a number, also with an exponent as in Fortran, 1.5D+3; empty is zero. Throws
  /// SceneError with the present line if the word is not a number, or not finite.
  /// @param in the file, for the message
  /// @param word the text
  double
  real_from(const KeywordFile &in, const std::string &word);
} // namespace Signorini
