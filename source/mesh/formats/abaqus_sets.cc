#include <signorini/mesh/formats/abaqus_sets.h>

#include <algorithm>
#include <cstdlib>

namespace Signorini
{
  namespace
  {
    bool
    is_number(const std::string &word)
    {
      return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
    }



    std::string
    in_instance(const std::string &instance, const std::string &name)
    {
      return instance.empty() ? name : instance + "." + name;
    }
  } // namespace



  std::size_t
  number_from(const KeywordFile &in, const std::string &word)
  {
    char             *end    = nullptr;
    const std::size_t number = std::strtoul(word.c_str(), &end, 10);
    if (word.empty() || *end != '\0' || word[0] == '-')
      in.fail("'" + word + "' should be the number of a node or element");
    return number;
  }



  unsigned int
  AbaqusSets::index(const std::size_t number, const std::string &instance) const
  {
    const auto *numbers = &index_of;
    if (!instance.empty())
      {
        const auto found = instances.find(upper_case(instance));
        if (found == instances.end())
          return none;
        numbers = &found->second;
      }
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



  void
  AbaqusSets::append(const KeywordFile         &in,
                     const std::string         &word,
                     std::vector<unsigned int> &members,
                     const std::string         &instance) const
  {
    if (word.empty())
      return;
    const std::string name = in_instance(instance, word);
    if (const AbaqusSet *set = find(name))
      {
        members.insert(members.end(), set->members.begin(), set->members.end());
        return;
      }
    const auto         dot    = name.rfind('.');
    const std::string  number = dot == std::string::npos ? name : name.substr(dot + 1);
    const unsigned int i =
      is_number(number) ?
        index(number_from(in, number), dot == std::string::npos ? "" : name.substr(0, dot)) :
        none;
    if (i == none)
      in.fail("'" + name + "' is no node, element or set that stands above");
    members.push_back(i);
  }



  void
  AbaqusSets::append_lines(KeywordFile &in, std::vector<unsigned int> &members) const
  {
    const std::string instance = in.value("INSTANCE");
    if (!instance.empty() && instances.count(upper_case(instance)) == 0)
      in.fail("there is no instance '" + instance + "' above");
    for (std::vector<std::string> words; in.next_line(words);)
      if (in.has("GENERATE"))
        {
          const std::size_t first = number_from(in, words.at(0)),
                            last  = words.size() > 1 && !words[1].empty() ?
                                      number_from(in, words[1]) :
                                      first,
                            step =
                              words.size() > 2 && !words[2].empty() ? number_from(in, words[2]) : 1;
          for (std::size_t i = first; i <= last; i += std::max<std::size_t>(step, 1))
            if (const unsigned int found = index(i, instance); found != none)
              members.push_back(found);
        }
      else
        for (const std::string &word : words)
          append(in, word, members, instance);
  }



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
