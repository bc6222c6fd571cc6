// SPDX-License-Identifier: Apache-2.0
#include "driver/contact_interfaces.h"

namespace Signorini
{
  template <int dim>
  nlohmann::ordered_json
  ContactInterfaces<dim>::save() const
  {
    auto result = nlohmann::ordered_json::array();
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        const ContactPair<dim> &pair = decisions.pairs[i];
        result.push_back(
          {{"name", pair.name},
           {"slave", pair.slave},
           {"master", pair.master},
           {"exchanged", pair.exchanged},
           {"reach", candidate_gap[i]},
           {"nearby", i < candidate_gap_near_solution.size() ? candidate_gap_near_solution[i] : 0.},
           {"near_approach", i < near_approach.size() ? near_approach[i] : -1.},
           {"known", i < known_tolerances.size() && known_tolerances[i].is_final},
           {"known_reach", i < known_tolerances.size() ? known_tolerances[i].candidate_gap : 0.},
           {"known_limit", i < known_tolerances.size() ? known_tolerances[i].limit : 0.},
           {"keeps_sides", unexchangeable.count(pair.name) > 0}});
      }
    return result;
  }



  template <int dim>
  void
  ContactInterfaces<dim>::load(const nlohmann::ordered_json &save)
  {
    if (save.size() != decisions.pairs.size())
      throw SceneError("--restart: there are " + std::to_string(decisions.pairs.size()) +
                       " contact pairs, but " + std::to_string(save.size()) +
                       " in the checkpoint; solve the scene from the start");
    candidate_gap_near_solution.assign(decisions.pairs.size(), 0.);
    known_tolerances.assign(decisions.pairs.size(), {});
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        ContactPair<dim> &pair = decisions.pairs[i];
        const auto       &was  = save.at(i);
        if (was.at("exchanged") != pair.exchanged)
          pair.exchange();
        if (was.at("name") != pair.name || was.at("slave") != pair.slave ||
            was.at("master") != pair.master)
          throw SceneError("--restart: contact pair " + pair.name + " of '" + pair.slave +
                           "' and '" + pair.master +
                           "' differs from that of the checkpoint; solve the scene from the start");
        candidate_gap[i]               = was.value("reach", candidate_gap[i]);
        candidate_gap_near_solution[i] = was.value("nearby", 0.);
        if (const double approach = was.value("near_approach", -1.); approach >= 0)
          {
            near_approach.resize(decisions.pairs.size(), 0.);
            near_approach[i] = approach;
          }
        if (was.value("known", false))
          known_tolerances[i] = {was.at("known_reach"), was.at("known_limit"), true};
        if (was.at("keeps_sides"))
          unexchangeable.insert(pair.name);
      }
  }



  template nlohmann::ordered_json
  ContactInterfaces<2>::save() const;
  template nlohmann::ordered_json
  ContactInterfaces<3>::save() const;
  template void
  ContactInterfaces<2>::load(const nlohmann::ordered_json &);
  template void
  ContactInterfaces<3>::load(const nlohmann::ordered_json &);
} // namespace Signorini
