// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/scene_text.h"
#include "mesh_import/decks/scene_writer.h"
#include "mesh_import/formats/abaqus_elements.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

// The sections of supports and loads.

namespace Signorini
{
  namespace
  {
    /// @return nodes and components of the entries of a list.
    std::vector<MemberTarget>
    targets_of(const std::vector<DeckModel::AtNodes> &list)
    {
      std::vector<MemberTarget> result;
      for (const DeckModel::AtNodes &one : list)
        result.push_back({one.nodes, one.components});
      return result;
    }



    /// @return component d of the vector from the axis of a centrifugal load to a point, (1 - e
    /// e^T) (x - c), as a formula; empty if it is zero everywhere.
    std::string
    distance_from_axis(const DeckModel::BodyLoad &load, const unsigned int d)
    {
      const auto &e = load.direction;
      std::string sum;
      for (unsigned int k = 0; k < 3; ++k)
        if (const double factor = (k == d ? 1 : 0) - e[d] * e[k]; factor != 0)
          sum += (sum.empty() ? "" : " + ") + long_text(factor) + "*(" + "xyz"[k] + " - (" +
                 long_text((*load.center)[k]) + "))";
      return sum.empty() ? "" : "(" + sum + ")";
    }



    /// Append an item; single nodes with equal values are joined in one item.
    void
    add_at_nodes(std::vector<SceneItem> &items,
                 SetNames               &names,
                 const bool              is_number,
                 SceneItem               item)
    {
      if (is_number)
        {
          const auto like = std::find_if(items.begin(), items.end(), [&](const SceneItem &one) {
            return one.name.compare(0, 5, "nodes") == 0 && std::equal(one.keys.begin() + 1,
                                                                      one.keys.end(),
                                                                      item.keys.begin() + 1,
                                                                      item.keys.end());
          });
          if (like != items.end())
            {
              like->keys[0].second += ", " + item.keys[0].second;
              return;
            }
          item.name = "nodes";
        }
      item.name = names.make_unique_name(item.name);
      items.push_back(item);
    }
  } // namespace



  // Nodes are grouped by the histories of their components, and each group is written once for each
  // interval of time in which it is prescribed.
  std::string
  SceneWriter::supports()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (const MemberGroup &group :
         groups_by_history(model.supports, targets_of(model.supported), true, histories))
      {
        const DeckModel::AtNodes &at = model.supported[group.target];
        // Components may be prescribed for different intervals.
        std::map<std::pair<double, double>, MemberGroup> by_span;
        for (unsigned int d = 0; d < dim; ++d)
          if (group.histories[d] != MemberGroup::free)
            {
              auto spans = history(group.histories[d]).spans;
              if (model.steps.empty())
                spans = {{0., 0.}};
              for (const auto &span : spans)
                {
                  MemberGroup &part = by_span.insert({span, group}).first->second;
                  if (part.histories == group.histories)
                    part.histories.fill(MemberGroup::free);
                  part.histories[d] = group.histories[d];
                }
            }
        const std::string where = by_span.empty() ? "" : nodes_of(group, at.name, "*BOUNDARY");
        if (where.empty())
          continue;
        const auto axes = axes_keys(at, "*BOUNDARY");
        if (!axes)
          continue;
        for (const auto &[span, part] : by_span)
          {
            SceneItem item{as_name(at.name),
                           {{"Nodes", where}, {"Displacement", vector_formula(part, "free")}}};
            item.keys.insert(item.keys.end(), axes->begin(), axes->end());
            if (span.first > 0)
              late_supports.emplace_back(at.name, span.first);
            if (span.first > 0)
              item.keys.emplace_back("Start time", text_of_time(span.first));
            if (!model.steps.empty() && span.second < model.steps.back().end)
              item.keys.emplace_back("End time", text_of_time(span.second));
            add_at_nodes(items, names, is_a_node(at), item);
          }
      }
    return section("Supports", items);
  }



  /// @return the coordinates of a vector of the deck in this dimension.
  std::string
  SceneWriter::plane_or_space(const std::array<double, 3> &v) const
  {
    return long_text(v[0]) + ", " + long_text(v[1]) + (dim == 3 ? ", " + long_text(v[2]) : "");
  }



  /// @return the keys for the axes of the nodes; nothing, with a report, if they are none of a
  /// plane scene.
  std::optional<std::vector<std::pair<std::string, std::string>>>
  SceneWriter::axes_keys(const DeckModel::AtNodes &at, const std::string &what)
  {
    if (!at.axes)
      return {{}};
    const auto &[is_cylindrical, first, second] = model.axes[*at.axes];
    std::array<double, 3> direction             = second;
    for (unsigned int d = 0; d < 3 && is_cylindrical; ++d)
      direction[d] -= first[d];
    // In the plane z is the third axis, and points out of it.
    const bool is_plane = is_cylindrical ?
                            direction[0] == 0 && direction[1] == 0 && direction[2] > 0 :
                            first[2] == 0 && first[0] * second[1] > first[1] * second[0];
    if (dim == 2 && !is_plane)
      {
        model.skip_item(what +
                          " in axes of *TRANSFORM that leave the plane, or are left-handed in it",
                        "",
                        what == "*CLOAD" ? "load" : "support");
        model.lacks_supports |= what == "*BOUNDARY";
        return {};
      }
    return {{{"Coordinates", is_cylindrical ? "cylindrical" : "rotated"},
             {"Axes", plane_or_space(first) + (dim == 3 ? "; " + plane_or_space(direction) : "")}}};
  }



  // All loads are in one section, with unique names.
  std::string
  SceneWriter::loads()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (const auto &list : {forces(), pressures(), body_forces(), gravity(), coupled_loads})
      for (SceneItem item : list)
        {
          item.name = names.make_unique_name(item.name);
          items.push_back(item);
        }
    return section("Loads", items);
  }



  // Forces of plane decks are divided by the thickness, since forces of the scene are per
  // thickness.
  std::vector<SceneItem>
  SceneWriter::forces()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (const MemberGroup &group :
         groups_by_history(model.forces, targets_of(model.loaded), false, histories))
      {
        const DeckModel::AtNodes &at = model.loaded[group.target];
        if (!has_content(group))
          continue;
        const std::string where = nodes_of(group, at.name, "*CLOAD");
        const auto        axes  = axes_keys(at, "*CLOAD");
        if (where.empty() || !axes)
          continue;
        SceneItem item{as_name(at.name),
                       {{"Nodes", where},
                        {"Force", vector_formula(group, "0", 1 / thickness_at(group.members))}}};
        item.keys.insert(item.keys.end(), axes->begin(), axes->end());
        add_at_nodes(items, names, is_a_node(at), item);
      }
    return items;
  }



  /// @return the number of cells at each face of the bodies.
  std::map<DeckModel::Face, unsigned int>
  SceneWriter::cells_at_faces() const
  {
    std::map<DeckModel::Face, unsigned int> n_cells;
    for (unsigned int e = 0; e < model.deck.mesh.elements.size(); ++e)
      if (std::any_of(all.begin(), all.end(), [&](const Body &body) {
            return body.has_element[e];
          }))
        for (DeckModel::Face face : abaqus_faces(model.deck.mesh.elements[e], ""))
          {
            std::sort(face.begin(), face.end());
            ++n_cells[face];
          }
    return n_cells;
  }



  /// Remove pressures on faces that two elements share, which are inside of bodies, and report
  /// them.
  void
  SceneWriter::skip_internal_pressures()
  {
    if (model.pressures.empty())
      return;
    const std::map<DeckModel::Face, unsigned int> n_cells = cells_at_faces();
    const std::size_t                             before  = model.pressures.size();
    for (auto one = model.pressures.begin(); one != model.pressures.end();)
      {
        const auto found = n_cells.find(one->first);
        one = found != n_cells.end() && found->second > 1 ? model.pressures.erase(one) : ++one;
      }
    const std::size_t n = before - model.pressures.size();
    if (n > 0)
      model.skip_item("pressures on " + std::to_string(n) + " faces inside of bodies", "", "load");
  }



  // The faces of each surface are grouped by their histories. Faces that an earlier surface has
  // loaded are not loaded again: their curves contain the sum already.
  std::vector<SceneItem>
  SceneWriter::pressures()
  {
    skip_internal_pressures();
    std::vector<SceneItem>    items;
    std::set<DeckModel::Face> done;
    for (const std::string &surface : model.pressed)
      {
        const std::set<DeckModel::Face>                      faces = model.faces_of(surface);
        std::map<unsigned int, std::vector<DeckModel::Face>> groups;
        std::size_t                                          n_faces = 0;
        for (const DeckModel::Face &face : faces)
          n_faces += model.pressures.count(face);
        for (const DeckModel::Face &face : faces)
          if (model.pressures.count(face) > 0 && done.insert(face).second)
            groups[histories.number(model.pressures.at(face))].push_back(face);
        for (const auto &[number, members] : groups)
          {
            // The surface of the deck is used if this group has all of its loaded faces; otherwise
            // a new set of faces is written.
            const bool        is_whole = members.size() == n_faces;
            const std::string where =
              is_whole ? surfaces(surface, "a pressure") :
                         faces_of(members, set_names.make_unique_name(as_name(surface) + " part"));
            if (!where.empty())
              items.push_back(
                {as_name(surface),
                 {{"Boundaries", where}, {"Pressure", formula(history(number).points)}}});
          }
      }
    return items;
  }



  // Elements are grouped by the histories of the three components.
  std::vector<SceneItem>
  SceneWriter::body_forces()
  {
    std::vector<MemberTarget> targets;
    for (const DeckModel::BodyForces &one : model.forced)
      {
        targets.push_back({one.elements, {{false, false, false}}});
        targets.back().components[one.component] = true;
      }
    std::vector<SceneItem> items;
    for (const MemberGroup &group : groups_by_history(model.body_forces, targets, false, histories))
      {
        const std::string name = model.forced[group.target].name;
        if (!has_content(group))
          continue;
        if (const std::string where = cells_of(group.members, name); !where.empty())
          items.push_back({"body force of " + as_name(name),
                           {{"Bodies", where}, {"Body force", vector_formula(group, "0")}}});
      }
    return items;
  }



  /// @return the density of each element; 0 where its material has none.
  std::vector<double>
  SceneWriter::densities() const
  {
    std::vector<double> result(model.deck.mesh.elements.size());
    for (const DeckModel::SolidSection &section : model.sections)
      if (const auto material = model.materials.find(section.material);
          material != model.materials.end())
        for (const unsigned int e : section.elements)
          result[e] = material->second.density.value_or(0);
    return result;
  }



  // Acceleration times density, for each density of the loaded elements.
  std::vector<SceneItem>
  SceneWriter::gravity()
  {
    const std::vector<double> density_of = densities();
    std::vector<SceneItem>    items;
    for (const DeckModel::BodyLoad &load : model.gravity)
      {
        std::map<double, std::vector<unsigned int>> by_density;
        for (const unsigned int e : load.elements)
          by_density[density_of[e]].push_back(e);
        for (const auto &[density, elements] : by_density)
          {
            // Gravity is a body force density times acceleration; without a density there is none.
            if (density == 0)
              {
                model.skip_item((load.center ? "centrifugal load on " : "gravity on ") + load.name +
                                  ", whose material has no *DENSITY",
                                "",
                                "load");
                continue;
              }
            const std::string where = cells_of(elements, load.name);
            if (where.empty())
              continue;
            const std::string size = formula(history(histories.number(load.size)).points, density);
            std::vector<std::string> words;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const std::string share =
                  load.center ? distance_from_axis(load, d) :
                                (load.direction[d] == 0 ? "" : long_text(load.direction[d]));
                words.push_back(share.empty() ? "0" : share + "*(" + size + ")");
              }
            items.push_back(
              {(load.center ? "centrifugal load of " : "gravity of ") + as_name(load.name),
               {{"Bodies", where}, {"Body force", join(words, "; ")}}});
          }
      }
    return items;
  }
} // namespace Signorini
