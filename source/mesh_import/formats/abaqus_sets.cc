// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_sets.h"

#include "geometry/memory.h"
#include <signorini/base/text.h>

#include <algorithm>
#include <cstdlib>

namespace Signorini
{
  namespace
  {
    /// @return whether a word consists of digits.
    bool
    is_number(const std::string &word)
    {
      return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
    }



    /// @return INSTANCE.NAME, or the name alone outside of instances.
    std::string
    in_instance(const std::string &instance, const std::string &name)
    {
      return instance.empty() ? name : instance + "." + name;
    }
  } // namespace



  void
  check_amount(const KeywordFile &in, const double number)
  {
    if (number > largest_number_of_cells())
      in.fail("*" + in.keyword() + " asks for " + short_text(number, 6) +
              " nodes, elements or members of a set, more than the memory of this machine could "
              "hold; is a number wrong?");
  }



  std::size_t
  number_from(const KeywordFile &in, const std::string &word)
  {
    char             *end    = nullptr;
    const std::size_t number = std::strtoul(word.c_str(), &end, 10);
    if (word.empty() || *end != '\0' || word[0] == '-')
      in.fail("'" + word + "' should be the number of a node or element");
    return number;
  }



  const AbaqusSets::Numbers *
  AbaqusSets::numbers_of(const std::string &instance) const
  {
    if (instance.empty())
      return &index_of;
    const auto found = instances.find(upper_case(instance));
    return found == instances.end() ? nullptr : &found->second;
  }



  unsigned int
  AbaqusSets::index(const std::size_t number, const std::string &instance) const
  {
    const Numbers *const numbers = numbers_of(instance);
    if (!numbers)
      return none;
    const auto found = numbers->find(number);
    return found == numbers->end() ? none : found->second;
  }



  AbaqusSet &
  AbaqusSets::get(const std::string &name)
  {
    return sets.insert({upper_case(name), {name, {}}}).first->second;
  }



  const AbaqusSet *
  AbaqusSets::find(const std::string &name) const
  {
    const auto found = sets.find(upper_case(name));
    return found == sets.end() ? nullptr : &found->second;
  }



  std::map<std::string, std::unordered_map<std::size_t, unsigned int>>
  AbaqusSets::all_numbers() const
  {
    auto result = instances;
    result[""]  = index_of;
    return result;
  }



  bool
  AbaqusSets::append_if_known(const std::string         &word,
                              std::vector<unsigned int> &members,
                              const std::string         &instance) const
  {
    // The name of a set may be a number. A number then refers to the node or element first, as in
    // CalculiX.
    const std::string name   = in_instance(instance, word);
    const auto        dot    = name.rfind('.');
    const std::string number = dot == std::string::npos ? name : name.substr(dot + 1);
    if (is_number(number))
      if (const unsigned int i = index(std::strtoul(number.c_str(), nullptr, 10),
                                       dot == std::string::npos ? "" : name.substr(0, dot));
          i != none)
        {
          members.push_back(i);
          return true;
        }
    const AbaqusSet *set = find(name);
    if (set)
      members.insert(members.end(), set->members.begin(), set->members.end());
    return set;
  }



  void
  AbaqusSets::append(const KeywordFile         &in,
                     const std::string         &word,
                     std::vector<unsigned int> &members,
                     const std::string         &instance) const
  {
    if (word.empty())
      return;
    if (!append_if_known(word, members, instance))
      in.fail("'" + in_instance(instance, word) + "' is no node, element or set that stands above");
    check_amount(in, members.size());
  }



  // Short ranges are looked up number by number; long ones, for which files write 1 to 999999999 to
  // say "all", by a pass over the numbers that exist.
  void
  AbaqusSets::append_range(const std::size_t          first,
                           const std::size_t          last,
                           const std::size_t          step,
                           const std::string         &instance,
                           std::vector<unsigned int> &members) const
  {
    const Numbers &numbers = *numbers_of(instance);
    if (const std::size_t n = (last - first) / step; n <= numbers.size())
      {
        for (std::size_t i = 0; i <= n; ++i)
          if (const unsigned int found = index(first + i * step, instance); found != none)
            members.push_back(found);
        return;
      }
    // Sorted by number, as a range is.
    std::map<std::size_t, unsigned int> in_range;
    for (const auto &[number, index] : numbers)
      if (number >= first && number <= last && (number - first) % step == 0)
        in_range.insert({number, index});
    for (const auto &[number, index] : in_range)
      members.push_back(index);
  }



  // With GENERATE each line is first, last, step; otherwise it has any number of words.
  std::vector<std::string>
  AbaqusSets::append_lines(KeywordFile &in, std::vector<unsigned int> &members) const
  {
    std::vector<std::string> unknown;
    const std::string        instance = in.value("INSTANCE");
    if (!instance.empty() && instances.count(upper_case(instance)) == 0)
      in.fail("there is no instance '" + instance + "' above");
    for (std::vector<std::string> words; in.next_line(words);)
      if (in.has("GENERATE"))
        {
          const auto number = [&](const std::size_t i, const std::size_t otherwise) {
            return i < words.size() && !words[i].empty() ? number_from(in, words[i]) : otherwise;
          };
          const std::size_t first = number_from(in, words.at(0)), last = number(1, first),
                            step = number(2, 1);
          if (step == 0 || last < first || (last - first) % step != 0)
            in.fail("GENERATE: steps of " + std::to_string(step) + " do not lead from " +
                    std::to_string(first) + " to " + std::to_string(last));
          append_range(first, last, step, instance, members);
        }
      else
        for (const std::string &word : words)
          if (!word.empty() && !append_if_known(word, members, instance))
            unknown.push_back(in_instance(instance, word));
    check_amount(in, members.size());
    return unknown;
  }



  // Sets of the instance get the name of the instance in front.
  bool
  AbaqusSets::add_instance(const std::string &name, const AbaqusSets &of)
  {
    if (!instances.insert({upper_case(name), of.index_of}).second)
      return false;
    for (const auto &[key, set] : of.sets)
      get(name + "." + set.name).members = set.members;
    return true;
  }
} // namespace Signorini
