// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_elements.h"
#include "mesh_import/formats/keyword_file.h"
#include "mesh_import/import_steps.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

namespace Signorini
{
  namespace
  {
    using Numbers = std::unordered_map<std::size_t, unsigned int>;

    /// @return a number of at most 18 digits, which fits into 64 bits. Throws SceneError.
    /// @param item the text that the message quotes
    std::size_t
    number_from(const std::string &word, const std::string &item)
    {
      constexpr unsigned int most_digits = 18;
      const std::string      digits      = trim(word);
      if (digits.empty() || digits.size() > most_digits ||
          digits.find_first_not_of("0123456789") != std::string::npos)
        throw SceneError("'" + trim(item) + "': write numbers as 3, ranges as 5-8");
      return std::stoul(digits);
    }



    /// @return the indices that belong to NUMBER, or to all of FIRST-LAST. Throws SceneError if the
    /// file lacks any of these numbers; ranges longer than the list of numbers are rejected before
    /// they are expanded.
    std::vector<unsigned int>
    indices_of(const std::string &range, const Numbers &numbers, const std::string &item)
    {
      const auto        dash  = range.find('-');
      const std::size_t first = number_from(range.substr(0, dash), item),
                        last  = dash == std::string::npos ?
                                  first :
                                  number_from(range.substr(dash + 1), item);
      if (last < first || last - first >= numbers.size())
        throw SceneError("'" + trim(item) + "': the file has no such numbers");
      std::vector<unsigned int> result;
      for (std::size_t number = first; number <= last; ++number)
        if (const auto found = numbers.find(number); found != numbers.end())
          result.push_back(found->second);
        else
          throw SceneError("'" + trim(item) + "': the file has no number " +
                           std::to_string(number) + " here");
      return result;
    }



    /// Call visit(NAME, ITEM) for all items of all sets. Throws SceneError if a name is taken.
    template <typename Visit>
    void
    read_sets(const std::string &text, const std::set<std::string> &taken, const Visit &visit)
    {
      for (const std::string &set : split(text, ';'))
        if (!trim(set).empty())
          {
            const auto        colon = set.find(':');
            const std::string name  = trim(set.substr(0, colon));
            if (colon == std::string::npos || name.empty())
              throw SceneError("'" + trim(set) + "': a set is NAME: numbers");
            if (taken.count(name) > 0)
              throw SceneError("'" + name + "' is a name in the file; take another one");
            for (const std::string &item : split(set.substr(colon + 1), ','))
              visit(name, trim(item));
          }
    }
  } // namespace



  NumberedSets::NumberedSets(const MeshFile &file, const std::vector<unsigned int> &cells)
  {
    for (const MeshFile::Group &group : file.groups)
      names.insert(group.name);
    for (const unsigned int e : cells)
      elements.insert({file.elements[e].number, e});
  }



  void
  NumberedSets::add_nodes(const std::string &text, MeshFile &file) const
  {
    read_sets(text, names, [&](const std::string &name, const std::string &item) {
      const auto        dot      = item.rfind('.');
      const std::string instance = dot == std::string::npos ? "" : item.substr(0, dot);
      const auto        found    = file.numbers.find(upper_case(instance));
      if (found == file.numbers.end())
        throw SceneError("'" + item + "': the nodes of the file have no numbers there");
      MeshFile::Group &group = file.group(name);
      for (const unsigned int node :
           indices_of(dot == std::string::npos ? item : item.substr(dot + 1), found->second, item))
        group.nodes.push_back(node);
    });
  }



  void
  NumberedSets::add_faces(const std::string &text, MeshFile &file) const
  {
    read_sets(text, names, [&](const std::string &name, const std::string &item) {
      const auto        dot   = item.find('.');
      const std::string label = dot == std::string::npos ? "" : upper_case(item.substr(dot + 1));
      MeshFile::Group  &group = file.group(name);
      for (const unsigned int e : indices_of(item.substr(0, dot), elements, item))
        {
          const auto faces = abaqus_faces(file.elements[e], label);
          if (label.empty() || faces.empty())
            throw SceneError("'" + item + "': a face is ELEMENT.LABEL with a label S1 to S6 that " +
                             "an element of type " + file.elements[e].type + " has");
          group.faces.insert(group.faces.end(), faces.begin(), faces.end());
        }
    });
  }



  void
  NumberedSets::add_cells(const std::string &text, MeshFile &file) const
  {
    read_sets(text, names, [&](const std::string &name, const std::string &item) {
      for (const unsigned int e : indices_of(item, elements, item))
        file.group(name).elements.push_back(e);
    });
  }
} // namespace Signorini
