#include <signorini/mesh/formats/abaqus_sets.h>

#include <algorithm>
#include <cstdlib>

namespace Signorini
{
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
  AbaqusSets::index(const std::size_t number) const
  {
    const auto found = index_of.find(number);
    return found == index_of.end() ? none : found->second;
  }



  AbaqusSet &
  AbaqusSets::get(const std::string &name)
  {
    return sets.insert({upper_case(name), {name, {}}}).first->second;
  }



  void
  AbaqusSets::append(const KeywordFile         &in,
                     const std::string         &word,
                     std::vector<unsigned int> &members) const
  {
    const auto set = sets.find(upper_case(word));
    if (set != sets.end())
      members.insert(members.end(), set->second.members.begin(), set->second.members.end());
    else if (!word.empty())
      {
        const bool         is_number = word.find_first_not_of("0123456789") == std::string::npos;
        const unsigned int i         = is_number ? index(number_from(in, word)) : none;
        if (i == none)
          in.fail("'" + word + "' is no node, element or set that stands above");
        members.push_back(i);
      }
  }



  void
  AbaqusSets::append_lines(KeywordFile &in, std::vector<unsigned int> &members) const
  {
    for (std::vector<std::string> words; in.next_line(words);)
      if (in.has("GENERATE"))
        {
          const std::size_t first = number_from(in, words.at(0)),
                            last  = words.size() > 1 ? number_from(in, words[1]) : first,
                            step  = words.size() > 2 ? number_from(in, words[2]) : 1;
          for (std::size_t i = first; i <= last; i += std::max<std::size_t>(step, 1))
            if (index(i) != none)
              members.push_back(index(i));
        }
      else
        for (const std::string &word : words)
          append(in, word, members);
  }
} // namespace Signorini
