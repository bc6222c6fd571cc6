// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"
#include "mesh_import/formats/abaqus_elements.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>

// The part of the reader for loads and temperatures.

namespace Signorini
{
  // Data lines: node or set, component, force.
  // Forces on one node add up within a step, also if the node is named by different sets.
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
        if (d >= 4 && d <= 6 && adds_moments(words[0], d, number(words, 2)))
          continue;
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
    // The mesh reader counts all *DLOAD keywords of the file, so that those of omitted steps have
    // to be counted here as well; otherwise the names of the surfaces would be shifted.
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
        // The mesh reader makes one surface for each different value of a keyword, in the order of
        // the lines.
        if (std::find(pressures.begin(), pressures.end(), value) == pressures.end())
          {
            pressures.push_back(value);
            model.pressed.push_back(name_of_loaded_faces(n_element_loads, pressures.size()));
          }
        // Each face is loaded once, however often its element is named.
        std::set<DeckModel::Face> faces;
        for (const unsigned int e : elements_of(words[0]))
          // Face k of an element has the label Pk as a load and Sk as part of a surface.
          for (DeckModel::Face face :
               abaqus_faces(model.deck.mesh.elements[e], "S" + label.substr(1)))
            {
              // A face is identified by its corners in ascending order, since two elements that
              // share it list them differently.
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
    // One message is enough, however many elements have such forces.
    for (const auto &[where, curve] : model.body_forces)
      if (curve.back().step < present_step())
        {
          skip_item("that OP=NEW ends BX, BY, BZ; they go on, as in CalculiX");
          break;
        }
  }



  // A pressure on all faces of a surface.
  // The name is recorded in any case, and the faces are stored one by one: a face may belong to
  // several surfaces, whose pressures add up.
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
    else if (label == "CENTRIF")
      add_centrifugal_load(words);
    else if (label == "BX" || label == "BY" || label == "BZ")
      {
        // The letters X, Y and Z follow each other, so that their distance from X is the component.
        const unsigned int    d = label[1] - 'X';
        DeckModel::BodyForces one{words[0], elements_of(words[0]), d};
        // Each element is loaded once, however often the set names it.
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
    // Data line: element or set, GRAV, size of the acceleration, its direction, which need not have
    // the length one.
    add_body_load({upper_case(words[0]), {}, direction(words, 3), {}}, number(words, 2));
  }



  // Elements or set, CENTRIF, square of the angular velocity, a point of the axis, its direction.
  void
  DeckReader::add_centrifugal_load(const Words &words)
  {
    add_body_load({upper_case(words[0]), {}, direction(words, 6), {}, triple(words, 3)},
                  number(words, 2));
  }



  // A unit vector by three numbers of a data line of *DLOAD, the first of them at a position.
  std::array<double, 3>
  DeckReader::direction(const Words &words, const unsigned int first) const
  {
    const auto [x, y, z] = triple(words, first);
    const double n       = std::sqrt(x * x + y * y + z * z);
    if (n == 0)
      in.fail("*DLOAD, " + upper_case(words[1]) + " needs a direction");
    return {{x / n, y / n, z / n}};
  }



  void
  DeckReader::add_body_load(DeckModel::BodyLoad load, const double size)
  {
    for (DeckModel::BodyLoad &other : model.gravity)
      // Directions are compared without tolerance: they are unit vectors that were computed from
      // the numbers of the deck in the same way.
      if (other.name == load.name && other.direction == load.direction &&
          other.center == load.center)
        return add(other.size, size);
    load.elements = elements_of(load.name);
    add(load.size, size);
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
