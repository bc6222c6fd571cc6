// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"

#include <signorini/parameters/raw.h>

#include <algorithm>
#include <sstream>

namespace Signorini
{
  std::string
  long_text(const double x, const unsigned int digits)
  {
    std::ostringstream out;
    out.precision(digits);
    out << x;
    return out.str();
  }



  std::string
  text_of_time(const double t)
  {
    return long_text(t, 15);
  }



  namespace
  {
    /// @return the keys of an item as lines with aligned equal signs.
    std::string
    keys_of(const SceneItem &item, const std::string &indent)
    {
      std::size_t width = 0;
      for (const auto &[key, value] : item.keys)
        width = std::max(width, key.size());
      std::string result;
      for (const auto &[key, value] : item.keys)
        result +=
          indent + "set " + key + std::string(width - key.size(), ' ') + " = " + value + "\n";
      return result;
    }



    /// @return lines with an indentation.
    std::string
    indented(const std::string &lines, const std::string &by)
    {
      std::istringstream in(lines);
      std::string        result;
      for (std::string line; std::getline(in, line);)
        if (!line.empty())
          result += by + line + "\n";
      return result;
    }
  } // namespace



  std::string
  section(const std::string &title, const std::vector<SceneItem> &items)
  {
    if (items.empty())
      return "";
    std::vector<std::string> names;
    std::string              body;
    for (const SceneItem &item : items)
      {
        names.push_back(item.name);
        body += "  subsection " + item.name + "\n" + keys_of(item, "    ") +
                indented(item.within, "    ") + "  end\n";
      }
    return "\nsubsection " + title + "\n  set Names = " + join(names) + "\n" + body + "end\n";
  }
} // namespace Signorini
