// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"
#include "mesh_import/decks/scene_writer.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <map>

// Equations between displacements.

namespace Signorini
{
  /// @return "BODY.NUMBER" of each node of a body; empty for others.
  std::vector<std::string>
  SceneWriter::names_of_nodes() const
  {
    std::vector<std::string> result(model.deck.mesh.nodes.size());
    for (const auto &[instance, numbers] : model.deck.mesh.numbers)
      for (const auto &[number, node] : numbers)
        for (const Body &body : all)
          if (body.has_node[node])
            result[node] =
              body.name + "." + (instance.empty() ? "" : instance + ".") + std::to_string(number);
    return result;
  }



  // Nodes that are on no body stand for the right-hand side: their displacements are prescribed.
  // Equations with the same right-hand side are one entry of the scene.
  std::string
  SceneWriter::equations()
  {
    if (model.equations.empty())
      return "";
    const std::vector<std::string>                                names = names_of_nodes();
    std::vector<std::pair<std::string, std::vector<std::string>>> by_value;
    unsigned int                                                  n_left = 0;
    for (const DeckModel::Equation &equation : model.equations)
      {
        std::vector<std::string> terms, values;
        bool                     is_known = true;
        for (const DeckModel::EquationTerm &term : equation)
          {
            is_known =
              is_known && term.component < dim && model.axes_of_nodes.count(term.node) == 0;
            if (!is_known || term.factor == 0)
              continue;
            if (!names[term.node].empty())
              terms.push_back(long_text(term.factor) + " " + names[term.node] + " " +
                              "xyz"[term.component]);
            else if (const std::string motion =
                       component_at(model.supports, term.node, term.component, "", -term.factor);
                     !motion.empty())
              {
                nodes_of_values.insert(term.node);
                if (motion != "0" && motion != "-0")
                  values.push_back(motion);
              }
            else
              is_known = false;
          }
        if (!is_known)
          {
            ++n_left;
            continue;
          }
        if (terms.empty())
          continue;
        const std::string value = values.empty() ? "0" : join(values, " + ");
        const auto        same = std::find_if(by_value.begin(), by_value.end(), [&](const auto &x) {
          return x.first == value;
        });
        (same == by_value.end() ? by_value.emplace_back(value, std::vector<std::string>()) : *same)
          .second.push_back(join(terms));
      }
    if (n_left > 0)
      {
        model.skip_item("*EQUATION of " + std::to_string(n_left) +
                          (n_left == 1 ? " line" : " lines") +
                          " with nodes that are on no solid and free, or that have a *TRANSFORM",
                        "",
                        "support");
        model.lacks_supports = true;
      }
    std::vector<SceneItem> items;
    SetNames               item_names;
    for (const auto &[value, list] : by_value)
      {
        items.push_back(
          {item_names.make_unique_name("equations"), {{"Equations", join(list, "; \\\n      ")}}});
        if (value != "0")
          items.back().keys.emplace_back("Value", value);
      }
    return section("Constraint equations", items);
  }
} // namespace Signorini
