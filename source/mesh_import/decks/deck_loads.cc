// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include "mesh_import/formats/abaqus_elements.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>

// The part of the reader for supports, loads and temperatures.

namespace Signorini
{
  /// @return whether the present keyword is part of the model or of a step that is computed;
  /// otherwise it is reported.
  bool
  DeckReader::counts()
  {
    const bool result = !in_step || step_counts;
    if (!result)
      skip_item("in a step that is left out");
    return result;
  }



  // Parameters other than the known ones are reported, and references to amplitudes that do not
  // exist.
  void
  DeckReader::check_parameters(const std::set<std::string> &known)
  {
    for (const auto &[name, value] : in.all_parameters())
      if (known.count(name) == 0)
        skip_item("its " + name);
    const std::string amplitude = in.value("AMPLITUDE");
    if (!amplitude.empty() && model.amplitudes.count(upper_case(amplitude)) == 0)
      skip_item("its AMPLITUDE=" + amplitude + ", which is not there above; values are ramped");
  }



  // The value of the present step, with the amplitude and type of the present keyword.
  DeckModel::Change
  DeckReader::change_to(const double value) const
  {
    const bool is_velocity = upper_case(in.value("TYPE")) == "VELOCITY";
    return {present_step(),
            value,
            upper_case(in.value("AMPLITUDE")),
            is_velocity ? DeckModel::Change::Kind::velocity : DeckModel::Change::Kind::value};
  }



  /// Set the value of the present step; the last of several lines is valid.
  void
  DeckReader::replace(Curve &curve, const double value) const
  {
    if (!curve.empty() && curve.back().step == present_step())
      curve.pop_back();
    curve.push_back(change_to(value));
  }



  /// Add to the value of the present step: several lines of one step add up, and replace those of
  /// earlier steps. Throws SceneError if their amplitudes differ.
  void
  DeckReader::add(Curve &curve, const double value) const
  {
    const DeckModel::Change change = change_to(value);
    if (curve.empty() || curve.back().step < change.step ||
        curve.back().kind == DeckModel::Change::Kind::removed)
      replace(curve, value);
    else if (curve.back().amplitude != change.amplitude)
      in.fail("loads of different amplitudes at one place in one step; CalculiX refuses them, and "
              "so does this program");
    else
      curve.back().value += value;
  }



  /// @return whether the present keyword is the first of its kind in this step and has OP=NEW,
  /// which removes all loads (supports) of earlier steps.
  bool
  DeckReader::removes_old(const std::string &kind)
  {
    return reported_kinds.insert(kind).second && in_step && upper_case(in.value("OP")) == "NEW";
  }



  // A value from an earlier step ends at the beginning of the present one.
  void
  DeckReader::remove_old(Curve &curve) const
  {
    if (curve.back().step < present_step() && curve.back().kind != DeckModel::Change::Kind::removed)
      curve.push_back({present_step(), 0., "", DeckModel::Change::Kind::removed});
  }



  /// @return a component of displacement or force, counted from 1; out of range if the number is no
  /// component.
  unsigned int
  DeckReader::component(const Words &words, const unsigned int i) const
  {
    return std::clamp(number(words, i), 0., 1000.);
  }



  /// @return the nodes of a number or set, each once, in ascending order. Throws SceneError if
  /// there are none of that name.
  std::vector<unsigned int>
  DeckReader::nodes_of(const std::string &target)
  {
    if (target.empty())
      in.fail("*" + in.keyword() + " without the name of a node or set");
    std::vector<unsigned int> nodes;
    model.deck.nodes.append(in, target, nodes);
    if (in.keyword() == "CLOAD")
      skip_repetitions(target, nodes);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }



  /// @return the elements of a number or set, as often as the deck names them; all elements without
  /// a target.
  DeckReader::Members
  DeckReader::elements_of(const std::string &target)
  {
    Members elements;
    if (target.empty())
      for (unsigned int e = 0; e < model.deck.mesh.elements.size(); ++e)
        elements.push_back(e);
    else
      model.deck.elements.append(in, target, elements);
    skip_repetitions(target, elements);
    return elements;
  }



  /// Report members that a set contains twice. CalculiX applies loads to them twice, Abaqus and
  /// this program once.
  void
  DeckReader::skip_repetitions(const std::string &target, Members members)
  {
    std::sort(members.begin(), members.end());
    if (std::adjacent_find(members.begin(), members.end()) != members.end())
      skip_item("on " + target +
                ", which names members twice: each is loaded once, as in Abaqus, "
                "but not in CalculiX");
  }



  /// @return the entry of a node or set in a list, which is created if there is none; null, with a
  /// report, if its nodes have local axes (*TRANSFORM). The pointer is valid until the next call.
  DeckModel::AtNodes *
  DeckReader::at_nodes(std::vector<DeckModel::AtNodes> &list, const std::string &target)
  {
    const std::string upper = upper_case(target);
    const auto        known = places.find({&list, upper});
    if (known != places.end())
      return &list[known->second];
    DeckModel::AtNodes one;
    const AbaqusSet   *set = model.deck.nodes.find(target);
    one.name               = set ? set->name : target;
    one.nodes              = nodes_of(target);
    if (set && target.find_first_not_of("0123456789") == std::string::npos)
      in.fail("a set of nodes is called as a number: " + target + "; give it another name");
    for (const unsigned int node : one.nodes)
      if (transformed.count(node) > 0)
        {
          skip_item("on nodes whose axes *TRANSFORM turns");
          model.lacks_supports |= in.keyword() == "BOUNDARY";
          return nullptr;
        }
    places[{&list, upper}] = list.size();
    list.push_back(one);
    return &list.back();
  }



  // Prescribe displacement components (0, 1, 2) of the nodes of a target.
  void
  DeckReader::hold(const std::string               &target,
                   const std::vector<unsigned int> &components,
                   const double                     value)
  {
    if (DeckModel::AtNodes *nodes = at_nodes(model.supported, target))
      for (const unsigned int d : components)
        {
          nodes->components[d] = true;
          for (const unsigned int node : nodes->nodes)
            replace(model.supports[{node, d}], value);
        }
  }



  /// @return whether the values of *BOUNDARY are displacements or constant velocities; others are
  /// reported.
  bool
  DeckReader::accepts_type()
  {
    const std::string type = upper_case(in.value("TYPE"));
    if (type.empty() || type == "DISPLACEMENT" || (type == "VELOCITY" && !in.has("AMPLITUDE")))
      return true;
    skip_item("its TYPE=" + type + (in.has("AMPLITUDE") ? " with an amplitude" : ""));
    model.lacks_supports = true;
    return false;
  }



  // Data lines: node or set, first component, last component, value; or node or set, type.
  void
  DeckReader::read_boundary()
  {
    if (!counts())
      return;
    if (removes_old("BOUNDARY"))
      for (auto &[where, curve] : model.supports)
        remove_old(curve);
    for (const std::string type : {"FIXED", "USER", "SUBMODEL"})
      if (in.has(type))
        {
          skip_item(type);
          return;
        }
    check_parameters({"OP", "AMPLITUDE", "TYPE"});
    if (!accepts_type())
      return;
    for (Words words; in.next_line(words);)
      {
        if (words.size() > 1 && !words[1].empty() && !std::isdigit(words[1][0]))
          {
            add_symmetry(words[0], upper_case(words[1]));
            continue;
          }
        // Components 1 to 3 are displacements, 4 to 6 rotations, others are of other physics.
        const unsigned int first = component(words, 1),
                           last =
                             words.size() > 2 && !words[2].empty() ? component(words, 2) : first;
        if (last > 6)
          skip_item("of temperatures, fluxes and the like");
        else if (last > 3)
          model.skip_item("*BOUNDARY of rotations", in.current_position());
        if (last < first)
          skip_item("whose last component is below the first");
        if (first < 1 || first > 3)
          continue;
        std::vector<unsigned int> components;
        for (unsigned int d = first; d <= std::min(last, 3u); ++d)
          components.push_back(d - 1);
        hold(words[0], components, number(words, 3));
      }
  }



  // The named types of *BOUNDARY: which components are zero.
  void
  DeckReader::add_symmetry(const std::string &target, const std::string &kind)
  {
    static const std::map<std::string, std::vector<unsigned int>> held  = {{"XSYMM", {0}},
                                                                           {"YSYMM", {1}},
                                                                           {"ZSYMM", {2}},
                                                                           {"PINNED", {0, 1, 2}},
                                                                           {"ENCASTRE", {0, 1, 2}},
                                                                           {"XASYMM", {1, 2}},
                                                                           {"YASYMM", {0, 2}},
                                                                           {"ZASYMM", {0, 1}}};
    const auto                                                    found = held.find(kind);
    if (found == held.end())
      skip_item("type " + kind);
    else
      hold(target, found->second, 0.);
  }



  // Data lines: node or set, component, force.
  void
  DeckReader::read_forces()
  {
    if (!counts())
      return;
    check_parameters({"OP", "AMPLITUDE"});
    if (removes_old("CLOAD"))
      for (auto &[where, curve] : model.forces)
        remove_old(curve);
    for (Words words; in.next_line(words);)
      {
        const unsigned int d = component(words, 1);
        if (d < 1 || d > 3)
          model.skip_item("*CLOAD of moments and fluxes", in.current_position());
        else if (DeckModel::AtNodes *nodes = at_nodes(model.loaded, words[0]))
          {
            nodes->components[d - 1] = true;
            for (const unsigned int node : nodes->nodes)
              add(model.forces[{node, d - 1}], number(words, 2));
          }
      }
  }



  // Data lines: element or set, label, value. Pressures P1 to P6 act on faces; the surfaces of the
  // different values have the names that the mesh reader gives them. Other labels are loads per
  // volume.
  void
  DeckReader::read_element_loads()
  {
    ++n_element_loads;
    if (!counts())
      return;
    check_parameters({"OP", "AMPLITUDE"});
    if (removes_old("DLOAD"))
      remove_distributed();
    std::vector<double> pressures; // in the order of the surfaces that the mesh reader makes
    for (Words words; in.next_line(words);)
      {
        const std::string label = words.size() > 1 ? upper_case(words[1]) : "";
        if (!is_pressure_label(label))
          {
            add_body_load(words);
            continue;
          }
        const double value = number(words, 2);
        if (std::find(pressures.begin(), pressures.end(), value) == pressures.end())
          {
            pressures.push_back(value);
            model.pressed.push_back(name_of_loaded_faces(n_element_loads, pressures.size()));
          }
        // Each face is loaded once, however often its element is named.
        std::set<DeckModel::Face> faces;
        for (const unsigned int e : elements_of(words[0]))
          for (DeckModel::Face face :
               abaqus_faces(model.deck.mesh.elements[e], "S" + label.substr(1)))
            {
              std::sort(face.begin(), face.end());
              faces.insert(face);
            }
        for (const DeckModel::Face &face : faces)
          add(model.pressures[face], value);
      }
  }



  /// OP=NEW removes the loads of *DLOAD and *DSLOAD alike, but not forces per volume, as in
  /// CalculiX.
  void
  DeckReader::remove_distributed()
  {
    for (auto &[face, curve] : model.pressures)
      remove_old(curve);
    for (DeckModel::BodyLoad &load : model.gravity)
      remove_old(load.size);
    for (const auto &[where, curve] : model.body_forces)
      if (curve.back().step < present_step())
        {
          skip_item("that OP=NEW ends BX, BY, BZ; they go on, as in CalculiX");
          break;
        }
  }



  // A pressure on all faces of a surface.
  void
  DeckReader::add_pressure(const std::string &surface, const double value)
  {
    model.pressed.push_back(surface);
    const std::set<DeckModel::Face> faces = model.faces_of(surface);
    if (faces.empty())
      skip_item("on '" + surface + "', which has no faces of elements");
    for (const DeckModel::Face &face : faces)
      add(model.pressures[face], value);
  }



  // GRAV: acceleration and direction; BX, BY, BZ: force per volume along an axis.
  void
  DeckReader::add_body_load(const Words &words)
  {
    const std::string label = words.size() > 1 ? upper_case(words[1]) : "";
    if (label == "GRAV")
      add_gravity(words);
    else if (label == "BX" || label == "BY" || label == "BZ")
      {
        const unsigned int    d = label[1] - 'X';
        DeckModel::BodyForces one{words[0], elements_of(words[0]), d};
        std::sort(one.elements.begin(), one.elements.end());
        one.elements.erase(std::unique(one.elements.begin(), one.elements.end()),
                           one.elements.end());
        for (const unsigned int e : one.elements)
          add(model.body_forces[{e, d}], number(words, 2));
        model.forced.push_back(one);
      }
    else
      skip_item("type " + label);
  }



  /// Add gravity. It replaces gravity of an earlier step with the same target and direction, and no
  /// other.
  void
  DeckReader::add_gravity(const Words &words)
  {
    const double x = number(words, 3), y = number(words, 4), z = number(words, 5);
    const double n = std::sqrt(x * x + y * y + z * z);
    if (n == 0)
      in.fail("*DLOAD, GRAV needs a direction");
    DeckModel::BodyLoad load{upper_case(words[0]), {}, {{x / n, y / n, z / n}}, {}};
    for (DeckModel::BodyLoad &other : model.gravity)
      if (other.name == load.name && other.direction == load.direction)
        return add(other.size, number(words, 2));
    load.elements = elements_of(words[0]);
    add(load.size, number(words, 2));
    model.gravity.push_back(load);
  }



  // Data lines: surface, P, pressure.
  void
  DeckReader::read_surface_loads()
  {
    if (!counts())
      return;
    check_parameters({"OP", "AMPLITUDE"});
    if (removes_old("DLOAD"))
      remove_distributed();
    for (Words words; in.next_line(words);)
      if (words.size() > 1 && upper_case(words[1]) == "P")
        add_pressure(words[0], number(words, 2));
      else
        skip_item("type " + (words.size() > 1 ? upper_case(words[1]) : ""));
  }



  // Local axes are not supported: loads and supports of these nodes are skipped where they occur.
  void
  DeckReader::read_transform()
  {
    Members nodes;
    model.deck.nodes.append(in, in.value("NSET"), nodes);
    for (const unsigned int node : nodes)
      for (unsigned int d = 0; d < 3; ++d)
        if (model.supports.count({node, d}) + model.forces.count({node, d}) > 0)
          in.fail("*TRANSFORM of nodes that have *BOUNDARY or *CLOAD above; put it before these");
    transformed.insert(nodes.begin(), nodes.end());
  }



  void
  DeckReader::read_initial_conditions()
  {
    if (upper_case(in.value("TYPE")) != "TEMPERATURE")
      {
        skip_item("bodies are at rest and without stress at the start");
        return;
      }
    read_temperatures_of_nodes(model.initial_temperatures);
  }



  // Data lines: node or set, temperature.
  void
  DeckReader::read_temperatures()
  {
    if (!counts())
      return;
    for (const std::string where : {"FILE", "USER", "SUBMODEL"})
      if (in.has(where))
        {
          skip_item("from " + where);
          return;
        }
    check_parameters({"OP", "AMPLITUDE"});
    const bool               is_new = removes_old("TEMPERATURE");
    DeckModel::Temperatures &here   = model.temperatures[present_step()];
    here.is_new |= is_new;
    read_temperatures_of_nodes(here);
  }



  void
  DeckReader::read_temperatures_of_nodes(DeckModel::Temperatures &temperatures)
  {
    for (Words words; in.next_line(words);)
      for (const unsigned int node : nodes_of(words[0]))
        temperatures.of_nodes[node] = {number(words, 1), upper_case(in.value("AMPLITUDE"))};
  }
} // namespace Signorini
