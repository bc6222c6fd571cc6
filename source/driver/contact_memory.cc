#include "driver/contact_setup.h"

namespace Signorini
{
  template <int dim>
  nlohmann::ordered_json
  ContactSetup<dim>::memory() const
  {
    auto result = nlohmann::ordered_json::array();
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        const ContactPair<dim> &pair = decisions.pairs[i];
        result.push_back({{"name", pair.name},
                          {"slave", pair.slave},
                          {"master", pair.master},
                          {"exchanged", pair.exchanged},
                          {"reach", reach[i]},
                          {"nearby", i < nearby.size() ? nearby[i] : 0.},
                          {"known", i < known.size() && known[i].is_known},
                          {"known_reach", i < known.size() ? known[i].reach : 0.},
                          {"known_limit", i < known.size() ? known[i].limit : 0.},
                          {"keeps_sides", kept.count(pair.name) > 0}});
      }
    return result;
  }



  template <int dim>
  void
  ContactSetup<dim>::remember(const nlohmann::ordered_json &memory)
  {
    if (memory.size() != decisions.pairs.size())
      throw SceneError("--restart: there are " + std::to_string(decisions.pairs.size()) +
                       " contact pairs, but " + std::to_string(memory.size()) +
                       " in the checkpoint; solve the scene from the start");
    nearby.assign(decisions.pairs.size(), 0.);
    known.assign(decisions.pairs.size(), {});
    for (unsigned int i = 0; i < decisions.pairs.size(); ++i)
      {
        ContactPair<dim> &pair = decisions.pairs[i];
        const auto       &was  = memory.at(i);
        if (was.at("exchanged") != pair.exchanged)
          pair.exchange();
        if (was.at("name") != pair.name || was.at("slave") != pair.slave ||
            was.at("master") != pair.master)
          throw SceneError("--restart: contact pair " + pair.name + " of '" + pair.slave +
                           "' and '" + pair.master +
                           "' differs from that of the checkpoint; solve the scene from the start");
        reach[i]  = was.value("reach", reach[i]);
        nearby[i] = was.value("nearby", 0.);
        if (was.value("known", false))
          known[i] = {was.at("known_reach"), was.at("known_limit"), true};
        if (was.at("keeps_sides"))
          kept.insert(pair.name);
      }
  }



  template nlohmann::ordered_json
  ContactSetup<2>::memory() const;
  template nlohmann::ordered_json
  ContactSetup<3>::memory() const;
  template void
  ContactSetup<2>::remember(const nlohmann::ordered_json &);
  template void
  ContactSetup<3>::remember(const nlohmann::ordered_json &);
} // namespace Signorini
