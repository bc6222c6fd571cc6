#include <signorini/import/import_deck.h>
#include <signorini/import/scene_writer.h>
#include <signorini/mesh/formats/abaqus_elements.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

namespace Signorini
{
  namespace
  {
    std::string
    text(const double x, const unsigned int digits = 12)
    {
      std::ostringstream out;
      out.precision(digits);
      out << x;
      return out.str();
    }



    /// Times may be as close as the two sides of a jump.
    std::string
    text_of_time(const double t)
    {
      return text(t, 15);
    }



    std::string
    keys_of(const SceneItem &item, const std::string &indent)
    {
      std::size_t width = 0;
      for (const auto &[key, value] : item.keys)
        width = std::max(width, key.size());
      std::string result;
      for (const auto &[key, value] : item.keys)
        result +=
          indent + "set " + key + std::string(width - key.size(), ' ') + " = " + value + "\n";
      return result;
    }



    std::string
    indented(const std::string &lines, const std::string &by)
    {
      std::istringstream in(lines);
      std::string        result;
      for (std::string line; std::getline(in, line);)
        if (!line.empty())
          result += by + line + "\n";
      return result;
    }



    std::string
    section(const std::string &title, const std::vector<SceneItem> &items)
    {
      if (items.empty())
        return "";
      std::vector<std::string> names;
      std::string              body;
      for (const SceneItem &item : items)
        {
          names.push_back(item.name);
          body += "  subsection " + item.name + "\n" + keys_of(item, "    ") +
                  indented(item.within, "    ") + "  end\n";
        }
      return "\nsubsection " + title + "\n  set Names = " + join(names) + "\n" + body + "end\n";
    }



    /// By the types of the plane elements. Throws SceneError where they differ.
    std::string
    model_of_types(const DeckModel &model, const std::string &file)
    {
      static const std::vector<std::pair<std::string, std::string>> models = {
        {"CAX", "axisymmetric"}, {"CPS", "plane stress"}, {"CPE", "plane strain"}};
      std::string result, type;
      for (const auto &element : model.deck.mesh.elements)
        for (const auto &[start, name] : models)
          if (element.type.compare(0, start.size(), start) == 0)
            {
              if (!result.empty() && result != name)
                throw SceneError(
                  "'" + file + "': has elements of " + result + " (" + type + ") and of " + name +
                  " (" + element.type +
                  "); a scene has one Model for all bodies. Give all elements one of these types, or mesh "
                  "the deck in three dimensions");
              result = name;
              type   = element.type;
            }
      return result.empty() ? "plane strain" : result;
    }
  } // namespace



  SceneWriter::SceneWriter(DeckModel given, const std::string &file)
    : model(std::move(given))
    , file(file)
    , histories(model)
  {
    for (const auto &group : model.deck.mesh.groups)
      set_names.unlike(group.name);
    bool has_solids = false, has_planes = false;
    for (const auto &element : model.deck.mesh.elements)
      {
        has_solids |= dimension_of(element.shape) == 3;
        has_planes |=
          dimension_of(element.shape) == 2 && element.type[0] == 'C' && element.type != "CONN3D2";
      }
    if (!has_solids && !has_planes)
      throw SceneError("'" + file +
                       "': no elastic solid is left: there are no elements of the "
                       "families C3D, CPE, CPS, CAX");
    dim = has_solids ? 3 : 2;
    if (dim == 2)
      kind = model_of_types(model, file);
    check_plane();
    leave_out_other_elements();
    make_bodies();
    is_finite = becomes_finite();
  }



  /// Supports and loads of plane elements are along x and y.
  void
  SceneWriter::check_plane() const
  {
    const MeshFile &mesh = model.deck.mesh;
    if (dim == 2)
      for (const auto &element : mesh.elements)
        if (dimension_of(element.shape) == 2)
          for (const unsigned int node : element.nodes)
            if (std::abs(mesh.nodes[node][2] - mesh.nodes[element.nodes[0]][2]) >
                1e-10 * mesh.nodes[node].norm())
              throw SceneError("'" + file + "': element " + std::to_string(element.number) + " (" +
                               element.type + ") does not lie in the plane of x and y");
  }



  /// Those of sections that are no solids here.
  void
  SceneWriter::leave_out_other_elements()
  {
    std::set<unsigned int> others;
    for (const auto &section : model.sections)
      for (const unsigned int e : section.elements)
        if (dimension_of(model.deck.mesh.elements[e].shape) < dim)
          others.insert(e);
    std::map<std::string, unsigned int> n;
    for (const unsigned int e : others)
      ++n[model.deck.mesh.elements[e].type];
    for (const auto &[type, count] : n)
      model.leave_out(std::to_string(count) + " elements of type " + type +
                        " (beside solids they have no stiffness)",
                      "*SOLID SECTION",
                      "body");
  }



  /// If the deck asks for it, and the program has it.
  bool
  SceneWriter::becomes_finite()
  {
    bool is_wanted = !model.nlgeom.empty(), is_warm = false;
    for (const Body &body : all)
      {
        is_wanted |= !model.materials.at(body.material).law.empty();
        for (const MaterialOfCells &one : body.others)
          is_wanted |= !model.materials.at(one.material).law.empty();
        is_warm |= !body.temperature.empty();
      }
    const bool        has_pressure = kind == "plane stress" && !model.pressures.empty();
    const std::string why          = is_warm      ? "thermal expansion" :
                                     has_pressure ? "pressures on edges of plane stress" :
                                                    "";
    if (is_wanted && !why.empty())
      model.leave_out("*STEP, NLGEOM (strains and rotations are small, as " + why + " needs it)",
                      model.nlgeom);
    return is_wanted && why.empty();
  }



  /// Linear ones of large deformation as CalculiX has them, by the strain of Green, or in decks of
  /// parts, which are of Abaqus, by logarithmic strain.
  std::vector<std::pair<std::string, std::string>>
  SceneWriter::material_keys(const DeckModel::Material &material) const
  {
    std::vector<std::pair<std::string, std::string>> keys;
    if (!material.law.empty())
      {
        std::vector<std::string> numbers;
        for (const double c : material.coefficients)
          numbers.push_back(text(c));
        keys.emplace_back("Law", material.law);
        keys.emplace_back("Coefficients", join(numbers));
      }
    else
      {
        if (is_finite)
          keys.emplace_back("Law",
                            model.deck.instances_of.empty() ? "Saint Venant-Kirchhoff" : "Hencky");
        keys.emplace_back("Young's modulus", text(*material.youngs_modulus));
      }
    keys.emplace_back("Poisson's ratio", text(*material.poissons_ratio));
    return keys;
  }



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
        // Nodes that were moved onto facets would not lie on surfaces that are rounded.
        if (std::any_of(model.pairs.begin(), model.pairs.end(), [&](const DeckModel::Pair &pair) {
              return pair.adjusts &&
                     std::any_of(body.boundaries.begin(),
                                 body.boundaries.end(),
                                 [&](const std::string &name) {
                                   return upper_case(name) == upper_case(pair.slave) ||
                                          upper_case(name) == upper_case(pair.master);
                                 });
            }))
          item.keys.emplace_back("Curved boundaries", "none");
        for (const auto &[key, sets] : {std::pair{"Node sets", body.node_sets},
                                        {"Face sets", body.face_sets},
                                        {"Cell sets", body.cell_sets}})
          if (!sets.empty())
            item.keys.emplace_back(key, join(sets, "; "));
        if (!body.temperature.empty())
          {
            item.keys.emplace_back("Thermal expansion", text(material.expansion.value_or(0)));
            item.keys.emplace_back("Temperature",
                                   formula(model.history(body.temperature, true).points));
            item.keys.emplace_back("Reference temperature", text(body.initial_temperature));
          }
        std::vector<SceneItem> others;
        SetNames               names;
        for (const MaterialOfCells &one : body.others)
          {
            const auto &other = model.materials.at(one.material);
            others.push_back({names.unlike(as_name(other.name)), {{"Cells", one.cells}}});
            for (const auto &key : material_keys(other))
              others.back().keys.push_back(key);
            if (!body.temperature.empty())
              others.back().keys.emplace_back("Thermal expansion",
                                              text(other.expansion.value_or(0)));
          }
        item.within = section("Materials", others);
        items.push_back(item);
      }
    return section("Bodies", items);
  }



  std::string
  SceneWriter::formula(const DeckModel::Points &points, const double factor) const
  {
    const auto same = [&](const auto &point) { return point.second == points[0].second; };
    if (std::all_of(points.begin(), points.end(), same))
      return text(factor * points[0].second);
    if (points.size() == 2 && points[0].second == 0)
      return text(factor * points[1].second) + "*t" +
             (points[1].first == 1 ? "" : "/" + text(points[1].first));
    std::vector<std::string> words{"t"};
    for (const auto &[t, y] : points)
      {
        words.push_back(text_of_time(t));
        words.push_back(text(factor * y));
      }
    return "table(" + join(words) + ")";
  }



  std::string
  SceneWriter::vector_formula(const MemberGroup &group,
                              const std::string &otherwise,
                              const double       factor) const
  {
    std::vector<std::string> words;
    for (unsigned int d = 0; d < dim; ++d)
      words.push_back(group.histories[d] == MemberGroup::free ?
                        otherwise :
                        formula(histories[group.histories[d]].points, factor));
    return join(words, "; ");
  }



  const DeckModel::History &
  SceneWriter::history(const unsigned int id)
  {
    end_steps_where_it_bends(histories[id]);
    return histories[id];
  }



  /// In one of the components that there are.
  bool
  SceneWriter::says_something(const MemberGroup &group)
  {
    bool result = false;
    for (unsigned int d = 0; d < dim; ++d)
      if (group.histories[d] != MemberGroup::free)
        {
          history(group.histories[d]);
          result = true;
        }
    return result;
  }



  /// What happens within a step is seen if load steps end there.
  void
  SceneWriter::end_steps_where_it_bends(const DeckModel::History &history)
  {
    for (const auto &[t, y] : history.points)
      for (const auto &step : model.steps)
        if (const double little = 1e-6 * (step.end - step.begin);
            t > step.begin + little && t < step.end - little)
          {
            const auto next = bends.lower_bound(t - little);
            if (next == bends.end() || *next > t + little)
              bends.insert(t);
          }
  }



  /// Nodes that nothing is on may be held by nothing, but not moved or loaded.
  std::string
  SceneWriter::kind_at_no_solid(const MemberGroup &group, const std::string &what)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (group.histories[d] != MemberGroup::free)
        for (const auto &[t, y] : history(group.histories[d]).points)
          if (y != 0)
            return what == "*CLOAD" ? "load" : "motion";
    return "model";
  }



  /// "BODY.SET, ..." of all bodies with nodes of the group; empty if there are none.
  std::string
  SceneWriter::nodes_of(const MemberGroup &group,
                        const std::string &target,
                        const std::string &what)
  {
    std::vector<std::string> result;
    std::set<unsigned int>   homeless(group.members.begin(), group.members.end());
    const std::string name = group.is_target ? target : set_names.unlike(as_name(target) + " part");
    for (Body &body : all)
      {
        std::set<unsigned int> here;
        for (const unsigned int node : group.members)
          if (body.has_node[node])
            {
              here.insert(node);
              homeless.erase(node);
            }
        if (here.empty())
          continue;
        result.push_back(body.name + "." + name);
        if (group.is_target)
          continue;
        std::vector<std::string> ranges;
        for (const auto &[instance, numbers] : model.deck.mesh.numbers)
          {
            std::vector<std::size_t> of_instance;
            for (const auto &[number, node] : numbers)
              if (here.erase(node) > 0)
                of_instance.push_back(number);
            for (const std::string &range : split(as_ranges(of_instance), ','))
              ranges.push_back((instance.empty() ? "" : instance + ".") + trim(range));
          }
        body.node_sets.push_back(name + ": " + join(ranges));
      }
    if (!homeless.empty())
      model.leave_out(what + " at " + std::to_string(homeless.size()) + " nodes of " + target +
                        " that are on no solid",
                      "",
                      kind_at_no_solid(group, what));
    return join(result);
  }



  namespace
  {
    std::vector<MemberTarget>
    targets_of(const std::vector<DeckModel::AtNodes> &list)
    {
      std::vector<MemberTarget> result;
      for (const DeckModel::AtNodes &one : list)
        result.push_back({one.nodes, one.components});
      return result;
    }



    /// Nodes of their own with the same value are one item.
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
      item.name = names.unlike(item.name);
      items.push_back(item);
    }
  } // namespace



  std::string
  SceneWriter::supports()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (const MemberGroup &group :
         groups_by_history(model.supports, targets_of(model.supported), true, histories))
      {
        const DeckModel::AtNodes &at = model.supported[group.target];
        // A component after the other, as long as it holds.
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
        for (const auto &[span, part] : by_span)
          {
            SceneItem item{as_name(at.name),
                           {{"Nodes", where}, {"Displacement", vector_formula(part, "free")}}};
            if (span.first > 0)
              late_supports.emplace_back(at.name, span.first);
            if (span.first > 0)
              item.keys.emplace_back("From", text_of_time(span.first));
            if (!model.steps.empty() && span.second < model.steps.back().end)
              item.keys.emplace_back("Until", text_of_time(span.second));
            add_at_nodes(items, names, is_a_node(at), item);
          }
      }
    return section("Supports", items);
  }



  /// "BODY.SURFACE, ..."
  std::string
  SceneWriter::surfaces(const std::string &surface, const std::string &what)
  {
    // A set of nodes may have the same name, in other case.
    bool has_faces = false;
    for (const auto &group : model.deck.mesh.groups)
      has_faces |= upper_case(group.name) == upper_case(surface) && !group.faces.empty();
    std::set<std::string> of_faces;
    for (const auto &group : model.deck.mesh.groups)
      if (!has_faces || !group.faces.empty())
        of_faces.insert(group.name);
    std::vector<std::string> result;
    for (const Body &body : all)
      for (const std::string &boundary : body.boundaries)
        if (upper_case(boundary) == upper_case(surface) && of_faces.count(boundary) > 0)
          result.push_back(body.name + "." + boundary);
    if (result.empty())
      model.leave_out(what + " on '" + surface + "', which has no whole face of a solid",
                      "",
                      what == "a pressure" ? "load" : "pair");
    return join(result);
  }



  /// Of plane bodies, whose forces are per thickness.
  double
  SceneWriter::thickness_at(const std::vector<unsigned int> &nodes) const
  {
    double thickness = 1;
    for (const Body &body : all)
      for (const unsigned int node : nodes)
        if (body.has_node[node])
          thickness = body.thickness;
    return dim == 2 ? thickness : 1;
  }



  std::string
  SceneWriter::loads()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (const auto &list : {forces(), pressures(), body_forces(), gravity()})
      for (SceneItem item : list)
        {
          item.name = names.unlike(item.name);
          items.push_back(item);
        }
    return section("Loads", items);
  }



  std::vector<SceneItem>
  SceneWriter::forces()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (const MemberGroup &group :
         groups_by_history(model.forces, targets_of(model.loaded), false, histories))
      {
        const DeckModel::AtNodes &at = model.loaded[group.target];
        if (!says_something(group))
          continue;
        if (const std::string where = nodes_of(group, at.name, "*CLOAD"); !where.empty())
          add_at_nodes(items,
                       names,
                       is_a_node(at),
                       {as_name(at.name),
                        {{"Nodes", where},
                         {"Force", vector_formula(group, "0", 1 / thickness_at(group.members))}}});
      }
    return items;
  }



  bool
  SceneWriter::is_a_node(const DeckModel::AtNodes &at) const
  {
    return at.nodes.size() == 1 && !model.deck.nodes.find(at.name);
  }



  /// "BODY.SET, ..." of a boundary that the scene makes.
  std::string
  SceneWriter::faces_of(const std::vector<DeckModel::Face> &faces, const std::string &name)
  {
    const MeshFile                 &mesh = model.deck.mesh;
    const std::set<DeckModel::Face> wanted(faces.begin(), faces.end());
    std::vector<std::string>        result;
    for (Body &body : all)
      {
        std::map<std::string, std::vector<std::size_t>> by_label;
        for (unsigned int e = 0; e < mesh.elements.size(); ++e)
          if (body.has_element[e])
            for (const std::string label : {"S1", "S2", "S3", "S4", "S5", "S6"})
              for (DeckModel::Face face : abaqus_faces(mesh.elements[e], label))
                {
                  std::sort(face.begin(), face.end());
                  if (wanted.count(face) > 0)
                    by_label[label].push_back(mesh.elements[e].number);
                }
        std::vector<std::string> ranges;
        for (const auto &[label, numbers] : by_label)
          for (const std::string &range : split(as_ranges(numbers), ','))
            ranges.push_back(trim(range) + "." + label);
        if (ranges.empty())
          continue;
        body.face_sets.push_back(name + ": " + join(ranges));
        result.push_back(body.name + "." + name);
      }
    return join(result);
  }



  /// Faces that two elements share are no boundary.
  void
  SceneWriter::leave_out_pressures_inside()
  {
    std::map<DeckModel::Face, unsigned int> n_cells;
    if (!model.pressures.empty())
      for (unsigned int e = 0; e < model.deck.mesh.elements.size(); ++e)
        if (std::any_of(all.begin(), all.end(), [&](const Body &body) {
              return body.has_element[e];
            }))
          for (DeckModel::Face face : abaqus_faces(model.deck.mesh.elements[e], ""))
            {
              std::sort(face.begin(), face.end());
              ++n_cells[face];
            }
    const std::size_t before = model.pressures.size();
    for (auto one = model.pressures.begin(); one != model.pressures.end();)
      {
        const auto found = n_cells.find(one->first);
        one = found != n_cells.end() && found->second > 1 ? model.pressures.erase(one) : ++one;
      }
    const std::size_t n = before - model.pressures.size();
    if (n > 0)
      model.leave_out("pressures on " + std::to_string(n) + " faces inside of bodies", "", "load");
  }



  std::vector<SceneItem>
  SceneWriter::pressures()
  {
    leave_out_pressures_inside();
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
            const bool        is_whole = members.size() == n_faces;
            const std::string where =
              is_whole ? surfaces(surface, "a pressure") :
                         faces_of(members, set_names.unlike(as_name(surface) + " part"));
            if (!where.empty())
              items.push_back(
                {as_name(surface),
                 {{"Boundaries", where}, {"Pressure", formula(history(number).points)}}});
          }
      }
    return items;
  }



  /// "BODY" or "BODY.SET, ..." of elements on solids.
  std::string
  SceneWriter::cells_of(const std::vector<unsigned int> &elements, const std::string &name)
  {
    std::vector<std::string> result;
    std::string              set;
    for (Body &body : all)
      {
        std::vector<std::size_t> numbers;
        for (const unsigned int e : elements)
          if (body.has_element[e])
            numbers.push_back(model.deck.mesh.elements[e].number);
        if (numbers.empty())
          continue;
        if (numbers.size() == static_cast<std::size_t>(
                                std::count(body.has_element.begin(), body.has_element.end(), true)))
          {
            result.push_back(body.name);
            continue;
          }
        if (set.empty())
          set = set_names.unlike(as_name(name) + " part");
        body.cell_sets.push_back(set + ": " + as_ranges(numbers));
        result.push_back(body.name + "." + set);
      }
    return join(result);
  }



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
        if (!says_something(group))
          continue;
        if (const std::string where = cells_of(group.members, name); !where.empty())
          items.push_back({"body force of " + as_name(name),
                           {{"Bodies", where}, {"Body force", vector_formula(group, "0")}}});
      }
    return items;
  }



  /// Of the elements; 0 where the material has none.
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
            if (density == 0)
              {
                model.leave_out("gravity on " + load.name + ", whose material has no *DENSITY",
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
              words.push_back(load.direction[d] == 0 ? "0" :
                                                       text(load.direction[d]) + "*(" + size + ")");
            items.push_back({"gravity of " + as_name(load.name),
                             {{"Bodies", where}, {"Body force", join(words, "; ")}}});
          }
      }
    return items;
  }



  std::string
  SceneWriter::pairs()
  {
    std::vector<SceneItem> items;
    SetNames               names;
    for (const auto &pair : model.pairs)
      {
        const std::string slaves  = surfaces(pair.slave, "the slave of a contact pair"),
                          masters = surfaces(pair.master, "the master of a contact pair");
        const auto found          = model.interactions.find(pair.interaction);
        if (!pair.interaction.empty() && found == model.interactions.end())
          model.leave_out("*SURFACE INTERACTION " + pair.interaction +
                            ", which is not there; contact of " + pair.slave + " on " +
                            pair.master + " is hard",
                          "",
                          "pair");
        const bool stays = found != model.interactions.end() &&
                           found->second.kind == DeckModel::Interaction::Kind::tied;
        for (const std::string &slave : split(slaves, ','))
          for (const std::string &master : split(masters, ','))
            {
              items.push_back({names.unlike(as_name(pair.slave) + " on " + as_name(pair.master)),
                               {{"Slave", slave}, {"Master", master}}});
              if (stays)
                items.back().keys.emplace_back("Separates", "no");
              const auto clearance =
                std::find_if(model.clearances.begin(),
                             model.clearances.end(),
                             [&](const auto &one) {
                               return upper_case(one.slave) == upper_case(pair.slave) &&
                                      upper_case(one.master) == upper_case(pair.master);
                             });
              if (clearance != model.clearances.end())
                items.back().keys.emplace_back("Initial gap", text(clearance->value));
            }
      }
    return section("Contact pairs", items);
  }



  std::string
  SceneWriter::steps() const
  {
    if (model.steps.empty())
      return "";
    std::set<double> times = bends;
    for (const auto &step : model.steps)
      times.insert(step.end);
    std::vector<std::string> ends;
    for (const double t : times)
      ends.push_back(text_of_time(t));
    return "\nsubsection Load steps\n  set Times = " + join(ends) + "\nend\n";
  }



  /// One method for all pairs: that of linear ones if there are no others.
  std::string
  SceneWriter::method()
  {
    using Kind       = DeckModel::Interaction::Kind;
    double stiffness = 0;
    bool   has_hard  = false;
    for (const auto &pair : model.pairs)
      if (const auto found = model.interactions.find(pair.interaction);
          found != model.interactions.end())
        {
          const auto &one = found->second;
          has_hard |= one.kind == Kind::hard;
          if (one.kind == Kind::linear && stiffness > 0 && one.stiffness != stiffness)
            model.leave_out("different slopes of *SURFACE BEHAVIOR (the largest counts for all)",
                            "",
                            "model");
          if (one.kind == Kind::linear)
            stiffness = std::max(stiffness, one.stiffness);
        }
    if (stiffness == 0)
      return "";
    if (has_hard)
      {
        model.leave_out("the slope of linear contact beside a hard one (all contact is hard)",
                        "",
                        "model");
        return "";
      }
    return "\nsubsection Contact method\n  set Method = penalty\n  subsection penalty\n    set "
           "Stiffness = " +
           text(stiffness) + "\n  end\nend\n";
  }



  std::string
  SceneWriter::free_motions() const
  {
    return std::string("\nsubsection Newton\n  # ") +
           (model.lacks_restraint ?
              "What was left out may have held bodies. Look at the forces that this takes." :
              "Motions that nothing stops are held, as CalculiX does; the run tells which.") +
           "\n  set Undetermined motions = hold\nend\n";
  }



  // Without what the scene file has a meaning for.
  std::vector<std::string>
  SceneWriter::left_out() const
  {
    std::vector<std::string> lines;
    for (const auto &[kind, what, places] : model.left_out)
      {
        std::string line = kind + ": " + what;
        if (!places[0].empty())
          line += ": " + places[0];
        if (places.size() > 1)
          line += " and " + std::to_string(places.size() - 1) + " more";
        std::replace(line.begin(), line.end(), ';', ',');
        std::replace_if(
          line.begin(), line.end(), [](const char c) { return c == '#' || c == '\\'; }, ' ');
        lines.push_back(line);
      }
    return lines;
  }



  /// A support that begins in a later step takes its nodes from where they are to its value in that
  /// step; a formula knows only its value.
  void
  SceneWriter::leave_out_ways_of_late_supports()
  {
    for (const auto &[name, begin] : late_supports)
      for (const auto &step : model.steps)
        if (const auto bend = bends.upper_bound(step.begin);
            step.begin == begin && bend != bends.end() && *bend < step.end)
          model.leave_out("the way of " + name +
                            " to the value of a support that begins in a later step, from where "
                            "it is; it goes there from zero",
                          "*BOUNDARY",
                          "support");
  }



  /// A load step for each of very many would take long.
  void
  SceneWriter::limit_bends()
  {
    constexpr std::size_t most = 100;
    for (const auto &step : model.steps)
      {
        const auto begin = bends.upper_bound(step.begin), end = bends.lower_bound(step.end);
        const auto n = std::distance(begin, end);
        if (static_cast<std::size_t>(n) <= most)
          continue;
        model.leave_out("the " + std::to_string(n) +
                          " bends of amplitudes in the step that ends at " +
                          text_of_time(step.end) + "; its end alone is solved",
                        "*AMPLITUDE",
                        "load");
        bends.erase(begin, end);
      }
  }



  void
  SceneWriter::write(std::ostream &scene)
  {
    // First all sections, which leave things out.
    const std::string what_acts = supports() + loads(); // and makes sets of the bodies
    limit_bends();
    leave_out_ways_of_late_supports();
    const std::string body = bodies() + what_acts + pairs() + method() + steps() + free_motions();
    scene << "# Made of " << file << "\nset Dimension = " << dim << "\n";
    if (dim == 2)
      scene << "set Model     = " << kind << "\n";
    if (is_finite)
      scene << "set Deformation = finite\n";
    scene << "set Title     = " << std::filesystem::path(file).stem().string() << "\n";
    if (const auto lines = left_out(); !lines.empty())
      scene << "set Left out  = \\\n  " << join(lines, "; \\\n  ") << "\n";
    scene << body;
  }



  void
  import_deck(const std::string &file, std::ostream &out, std::ostream &messages)
  {
    SceneWriter writer(read_deck_model(file), file);
    writer.write(out);
    for (const std::string &line : writer.left_out())
      messages << "warning: " << file << ": left out: " << line << "\n";
  }
} // namespace Signorini
