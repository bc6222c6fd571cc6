// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/history_groups.h"

#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  // Curves are looked up first, because a history is expensive to compute and to compare.
  unsigned int
  Histories::number(const DeckModel::Curve &curve)
  {
    if (const auto known = of_curves.find(curve); known != of_curves.end())
      return known->second;
    const DeckModel::History history = model.history(curve);
    const unsigned int       result  = std::find(all.begin(), all.end(), history) - all.begin();
    if (result == all.size())
      all.push_back(history);
    of_curves[curve] = result;
    return result;
  }



  namespace
  {
    using Members = std::vector<unsigned int>;

    /// @return the members of one target by the number of their history in one component.
    std::map<unsigned int, Members>
    by_history(const DeckModel::NodeCurves &curves,
               const Members               &members,
               const unsigned int           component,
               Histories                   &histories)
    {
      std::map<unsigned int, Members> result;
      for (const unsigned int member : members)
        result[histories.number(curves.at({member, component}))].push_back(member);
      return result;
    }
  } // namespace



  // Target by target and component by component: members that no earlier target had are grouped by
  // their histories. Groups with the same members in several components are joined.
  std::vector<MemberGroup>
  groups_by_history(const DeckModel::NodeCurves     &curves,
                    const std::vector<MemberTarget> &targets,
                    const bool                       may_overlap,
                    Histories                       &histories)
  {
    std::vector<MemberGroup>                        result;
    std::set<std::pair<unsigned int, unsigned int>> done; // members and components
    for (unsigned int t = 0; t < targets.size(); ++t)
      {
        const std::size_t before = result.size();
        for (unsigned int d = 0; d < 3; ++d)
          if (targets[t].components[d])
            {
              // Members that an earlier target has in this component are excluded.
              Members open;
              for (const unsigned int member : targets[t].members)
                if (done.insert({member, d}).second)
                  open.push_back(member);
              // Where histories may overlap, a target whose members have equal histories stays
              // whole.
              auto groups = by_history(curves, open, d, histories);
              if (may_overlap && !open.empty())
                if (auto whole = by_history(curves, targets[t].members, d, histories);
                    whole.size() == 1)
                  groups = std::move(whole);
              for (const auto &[number, members] : groups)
                {
                  const auto same = std::find_if(result.begin() + before,
                                                 result.end(),
                                                 [&](const MemberGroup &other) {
                                                   return other.members == members;
                                                 });
                  if (same != result.end())
                    same->histories[d] = number;
                  else
                    {
                      result.push_back({members, {}, t, members == targets[t].members});
                      result.back().histories.fill(MemberGroup::free);
                      result.back().histories[d] = number;
                    }
                }
            }
      }
    return result;
  }



  std::string
  SetNames::make_unique_name(const std::string &name)
  {
    if (taken.insert(name).second)
      return name;
    for (unsigned int &i = next.insert({name, 2}).first->second;; ++i)
      if (const std::string result = name + " " + std::to_string(i); taken.insert(result).second)
        return result;
  }



  std::string
  as_ranges(std::vector<std::size_t> numbers)
  {
    std::sort(numbers.begin(), numbers.end());
    std::vector<std::string> words;
    for (std::size_t first = 0, next; first < numbers.size(); first = next)
      {
        next = first + 1;
        while (next < numbers.size() && numbers[next] == numbers[next - 1] + 1)
          ++next;
        words.push_back(std::to_string(numbers[first]));
        if (next - first > 1)
          words.back() += "-" + std::to_string(numbers[next - 1]);
      }
    return join(words);
  }
} // namespace Signorini
