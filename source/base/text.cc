// SPDX-License-Identifier: Apache-2.0
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iomanip>
#include <istream>
#include <numeric>
#include <sstream>

namespace Signorini
{
  namespace
  {
    /// @return a message without control characters, and shortened if it is very long: both may
    /// come from binary files.
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
    /// @return a word in lower case.
    std::string
    lower(std::string word)
    {
      std::transform(word.begin(), word.end(), word.begin(), ::tolower);
      return word;
    }

    /// @return the Levenshtein distance of two words: the smallest number of insertions, deletions
    /// and substitutions. One row of the matrix of distances is kept. O(length a times length b).
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
    // Otherwise a name that contains the word.
    if (best.empty() && word.size() > 2)
      for (const std::string &candidate : candidates)
        if (lower(candidate).find(lower(word)) != std::string::npos)
          return candidate;
    return best;
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
} // namespace Signorini
