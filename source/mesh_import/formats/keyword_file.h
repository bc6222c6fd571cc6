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
  /// CONTACT PAIR and CONTACTPAIR are the same keyword.
  struct IgnoringBlanks
  {
    bool
    operator()(const std::string &a, const std::string &b) const;
  };

  /// A file of keywords with data lines, as Abaqus and CalculiX read them:
  ///
  ///     ** comment
  ///     *KEYWORD, PARAMETER=value, PARAMETER
  ///     data, data, data
  ///
  /// Keywords and parameters may be in any case, and with or without blanks. What is in quotes may
  /// have blanks and commas. A keyword line that ends with a comma goes on in the next line.
  /// *INCLUDE, INPUT=file is followed, beside the file that says so, among data lines too; of any
  /// other keyword, INPUT=file has the first data lines. *PARAMETER defines names of numbers by
  /// formulas, `name = formula` a line, which `<name>` stands for in all lines that follow.
  class KeywordFile
  {
  public:
    explicit KeywordFile(const std::string &file_name);

    /// Go on to the next keyword; false at the end of the file.
    bool
    next_keyword();

    /// Without the star, in upper case, with single blanks.
    const std::string &
    keyword() const
    {
      return my_keyword;
    }

    bool
    has(const std::string &parameter) const;

    /// The value without quotes, as it is written; empty if there is none.
    std::string
    value(const std::string &parameter) const;

    /// The next data line of this keyword, split at the commas; false if there are no more.
    bool
    next_line(std::vector<std::string> &words);

    /// All parameters with their values, by names in upper case.
    const std::map<std::string, std::string, IgnoringBlanks> &
    all_parameters() const
    {
      return parameters;
    }

    /// "FILE, line LINE" of the present keyword or data line.
    std::string
    current_position() const
    {
      return name + ", line " + std::to_string(line_number);
    }

    /// Did the last data line end with a comma?
    bool
    has_continuation() const
    {
      return my_has_continuation;
    }

    /// "mesh file 'FILE', line LINE: ", for messages about it later on.
    std::string
    position_in_messages() const;

    /// Throws SceneError("mesh file 'FILE', line LINE: what").
    [[noreturn]] void
    fail(const std::string &what) const;

  private:
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
    /// If the line is *INCLUDE.
    bool
    follow_include(const std::string &line);
    void
    read_parameters();
    /// With numbers for <names>.
    std::string
    evaluated(std::string line) const;

    std::vector<Source>                                sources; ///< the last one is being read
    std::string                                        name, my_keyword, pending;
    std::string                                        data_file; ///< of INPUT=, until it is opened
    unsigned int                                       line_number = 0;
    std::map<std::string, std::string, IgnoringBlanks> parameters;
    std::shared_ptr<Definitions>                       numbers; ///< of *PARAMETER; null: none
    bool                                               my_has_continuation = false;
  };

  std::string
  upper_case(std::string text);

  /// A number as Fortran writes it too, 1.5D+3; empty is zero. Throws SceneError with the present
  /// line if it is none, or not finite.
  double
  real_from(const KeywordFile &in, const std::string &word);
} // namespace Signorini
