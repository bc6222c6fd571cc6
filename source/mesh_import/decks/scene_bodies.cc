// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"
#include "mesh_import/decks/scene_writer.h"
#include "mesh_import/formats/rigid_motion.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// The sections of bodies and contact pairs.

namespace Signorini
{
  using namespace dealii;

  /// @return the keys of a material. Linear elastic materials at finite strain are Saint
  /// Venant-Kirchhoff's in decks of CalculiX, and Hencky's (logarithmic strain) in decks with
  /// parts, which are of Abaqus.
  std::vector<std::pair<std::string, std::string>>
  SceneWriter::material_keys(const DeckModel::Material &material) const
  {
    std::vector<std::pair<std::string, std::string>> keys;
    if (!material.law.empty())
      {
        std::vector<std::string> numbers;
        for (const double c : material.coefficients)
          numbers.push_back(long_text(c));
        keys.emplace_back("Law", material.law);
        keys.emplace_back("Coefficients", join(numbers));
      }
    else
      {
        if (is_finite_strain)
          keys.emplace_back("Law",
                            model.deck.instances_of.empty() ? "Saint Venant-Kirchhoff" : "Hencky");
        keys.emplace_back("Young's modulus", long_text(*material.youngs_modulus));
      }
    keys.emplace_back("Poisson's ratio", long_text(*material.poissons_ratio));
    return keys;
  }



  // Each body has its mesh, materials, sets, and temperature.
  std::string
  SceneWriter::bodies() const
  {
    std::vector<SceneItem> items;
    for (const Body &body : all)
      {
        const auto &material = model.materials.at(body.material);
        SceneItem   item{body.name, {{"Mesh", "file"}, {"File", file}}};
        if (n_pieces > 1)
          item.keys.emplace_back("Part", body.part);
        for (const auto &key : material_keys(material))
          item.keys.push_back(key);
        if (body.is_quadratic)
          item.keys.emplace_back("Degree", "2");
        // Equations join nodes that coincide.
        if (!model.equations.empty())
          item.keys.emplace_back("Coinciding nodes", "keep");
        // Nodes that were moved onto the facets of a master would not be on its surface if that
        // were reconstructed as a curved one.
        if (std::any_of(body.boundaries.begin(),
                        body.boundaries.end(),
                        [&](const std::string &name) {
                          return model.deck.adjusted.count(upper_case(name)) > 0;
                        }))
          item.keys.emplace_back("Curved boundaries", "none");
        for (const auto &[key, sets] : {std::pair{"Node sets", body.node_sets},
                                        {"Face sets", body.face_sets},
                                        {"Cell sets", body.cell_sets}})
          if (!sets.empty())
            item.keys.emplace_back(key, join(sets, "; "));
        if (!body.temperature.empty())
          {
            item.keys.emplace_back("Thermal expansion", long_text(material.expansion.value_or(0)));
            item.keys.emplace_back("Temperature",
                                   formula(model.history(body.temperature, true).points));
            item.keys.emplace_back("Reference temperature", long_text(body.initial_temperature));
          }
        std::vector<SceneItem> others;
        SetNames               names;
        for (const MaterialOfCells &one : body.others)
          {
            const auto &other = model.materials.at(one.material);
            others.push_back({names.make_unique_name(as_name(other.name)), {{"Cells", one.cells}}});
            for (const auto &key : material_keys(other))
              others.back().keys.push_back(key);
            if (!body.temperature.empty())
              others.back().keys.emplace_back("Thermal expansion",
                                              long_text(other.expansion.value_or(0)));
          }
        item.within = section("Materials", others);
        items.push_back(item);
      }
    return section("Bodies", items);
  }



  // A surface of a deck may be on several bodies: each combination of them is a pair.
  /// @return the keys that turn the master of a cyclic tie to where the slave is.
  std::vector<std::pair<std::string, std::string>>
  SceneWriter::sector_keys(const DeckModel::Pair &pair) const
  {
    if (!pair.sectors)
      return {};
    const auto &[n, first, second] = *pair.sectors;
    const Point<3> a(first[0], first[1], first[2]), b(second[0], second[1], second[2]);
    // The angle has the sign with which the middle of the master comes nearer to that of the slave.
    const Point<3> slave = middle_of(pair.slave), master = middle_of(pair.master);
    const double   angle    = 2 * numbers::PI / n;
    const auto     distance = [&](const double sign) {
      return RigidMotion::about_axis(a, b, sign * angle)(master).distance(slave);
    };
    const bool         is_positive = distance(1) < distance(-1);
    const Tensor<1, 3> e           = (b - a) / (b - a).norm();
    // In the plane the axis is z, along which the deck's axis may point downwards.
    const double sign = (is_positive ? 1 : -1) * (dim == 2 && e[2] < 0 ? -1 : 1);
    return {{"Master rotation", (sign < 0 ? "-360/" : "360/") + long_text(n)},
            {"Master axis",
             plane_or_space(first) +
               (dim == 3 ? "; " + plane_or_space({{e[0], e[1], e[2]}}) : "")}};
  }



  /// @return the mean position of the nodes of a surface or set.
  Point<3>
  SceneWriter::middle_of(const std::string &surface) const
  {
    std::set<unsigned int> nodes;
    for (const auto &group : model.deck.mesh.groups)
      if (upper_case(group.name) == upper_case(surface))
        {
          nodes.insert(group.nodes.begin(), group.nodes.end());
          for (const auto &face : group.faces)
            nodes.insert(face.begin(), face.end());
        }
    Point<3> result;
    for (const unsigned int node : nodes)
      result += model.deck.mesh.nodes[node] / double(nodes.size());
    return result;
  }



  /// Write the last of the items once for each part of a time span in which *MODEL CHANGE lets it
  /// act.
  void
  SceneWriter::divide_by_times(const DeckModel::Pair  &pair,
                               const double            begin,
                               const double            end,
                               SetNames               &names,
                               std::vector<SceneItem> &items) const
  {
    const SceneItem one = items.back();
    items.pop_back();
    // Begins and ends in turn; the last span has no end if their number is odd.
    std::vector<double> bounds = {0.};
    bounds.insert(bounds.end(), pair.changes.begin(), pair.changes.end());
    bool is_first = true;
    for (unsigned int i = 0; i < bounds.size(); i += 2)
      {
        const double from = std::max(begin, bounds[i]),
                     to   = i + 1 == bounds.size() ? end : std::min(end, bounds[i + 1]);
        if (to <= from)
          continue;
        items.push_back(one);
        if (!std::exchange(is_first, false))
          items.back().name = names.make_unique_name(one.name);
        if (from > 0)
          items.back().keys.emplace_back("Start time", text_of_time(from));
        if (std::isfinite(to))
          items.back().keys.emplace_back("End time", text_of_time(to));
      }
  }



  /// @return the keys of a pair with an interaction: friction, pressure and overclosure, ties.
  std::vector<std::pair<std::string, std::string>>
  SceneWriter::interaction_keys(const DeckModel::Interaction &one) const
  {
    using Kind = DeckModel::Interaction::Kind;
    std::vector<std::pair<std::string, std::string>> keys;
    if (one.kind == Kind::tied)
      keys.emplace_back("Law", "tied");
    if (one.kind == Kind::never_separates)
      keys.emplace_back("Separation", "none");
    const bool has_friction =
      one.kind != Kind::tied && !one.friction.empty() && one.friction != "0";
    if (has_friction)
      keys.emplace_back("Friction", one.friction);
    if (has_friction && one.shear_limit > 0)
      keys.emplace_back("Friction limit", long_text(one.shear_limit));
    keys.insert(keys.end(), one.overclosure.begin(), one.overclosure.end());
    if (one.stick_slope > 0 && (one.kind == Kind::tied || has_friction))
      keys.emplace_back("Tangential stiffness", long_text(one.stick_slope));
    return keys;
  }



  std::string
  SceneWriter::pairs()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (SceneItem one : coupled_pairs)
      {
        one.name = names.make_unique_name(one.name);
        items.push_back(one);
      }
    for (const auto &pair : model.pairs)
      {
        const auto        rigid   = rigid_masters.find(upper_case(pair.master));
        const std::string slaves  = surfaces(pair.slave, "the slave of a contact pair"),
                          masters = rigid != rigid_masters.end() ?
                                      rigid->second :
                                      surfaces(pair.master, "the master of a contact pair");
        // A pair whose interaction is missing has hard contact, the default.
        auto interaction = model.interactions.find(pair.interaction);
        if (!pair.interaction.empty() && interaction == model.interactions.end())
          model.skip_item("*SURFACE INTERACTION " + pair.interaction +
                            ", which is not there; contact of " + pair.slave + " on " +
                            pair.master + " is hard",
                          "",
                          "pair");
        if (pair.cyclic_tie && !pair.sectors)
          {
            model.skip_item("*TIE, CYCLIC SYMMETRY of " + pair.slave +
                              " without a *CYCLIC SYMMETRY MODEL",
                            "");
            model.lacks_supports = true;
            continue;
          }
        // The interactions of the pair, one after the other.
        double begin = 0;
        for (const DeckModel::Interaction *one =
               interaction == model.interactions.end() ? nullptr : &interaction->second;
             ;)
          {
            const bool   is_last = !one || !one->successor;
            const double end =
              is_last ? std::numeric_limits<double>::infinity() : one->successor->first;
            for (const std::string &slave : split(slaves, ','))
              for (const std::string &master : split(masters, ','))
                if (end > begin)
                  {
                    items.push_back(
                      {names.make_unique_name(as_name(pair.slave) + " on " + as_name(pair.master)),
                       {{"Slave", slave}, {"Master", master}}});
                    auto      &keys = items.back().keys;
                    const auto add  = [&](const auto &more) {
                      keys.insert(keys.end(), more.begin(), more.end());
                    };
                    add(sector_keys(pair));
                    if (pair.farthest > 0)
                      keys.emplace_back("Search distance", long_text(pair.farthest));
                    add(interaction_keys(one ? *one : DeckModel::Interaction()));
                    // A clearance of the deck replaces the gap that follows from the coordinates.
                    const auto clearance =
                      std::find_if(model.clearances.begin(),
                                   model.clearances.end(),
                                   [&](const auto &of) {
                                     return upper_case(of.slave) == upper_case(pair.slave) &&
                                            upper_case(of.master) == upper_case(pair.master);
                                   });
                    if (clearance != model.clearances.end())
                      keys.emplace_back("Initial gap", long_text(clearance->value));
                    divide_by_times(pair, begin, end, names, items);
                  }
            if (is_last)
              break;
            begin = end;
            one   = &model.interactions.at(one->successor->second);
          }
      }
    return section("Contact pairs", items);
  }
} // namespace Signorini
