#include <signorini/import/deck_reader.h>
#include <signorini/mesh/formats/abaqus_elements.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>

// What acts on the bodies: supports, loads, temperatures.

namespace Signorini
{
  /// Is the model, or a step that is computed.
  bool
  DeckReader::counts() const
  {
    return !in_step || step_counts;
  }



  void
  DeckReader::set(Curve &curve, const double value) const
  {
    const unsigned int step = in_step ? model.steps.size() : 0;
    if (!curve.empty() && curve.back().step == step)
      curve.pop_back();
    curve.push_back({step, value, upper_case(in.value("AMPLITUDE"))});
  }



  /// Of a displacement or force, counted from 1; what no unsigned int can be is none either.
  unsigned int
  DeckReader::component(const Words &words, const unsigned int i) const
  {
    return std::clamp(number(words, i), 0., 1000.);
  }



  /// OP=NEW ends what earlier steps have begun.
  void
  DeckReader::remove_old(const std::vector<Curve *> &curves) const
  {
    if (upper_case(in.value("OP")) != "NEW")
      return;
    const unsigned int step = in_step ? model.steps.size() : 0;
    for (Curve *curve : curves)
      if (!curve->empty() && curve->back().step < step)
        curve->push_back({step, 0., ""});
  }



  /// The entry of a node or set; null if it has axes of its own.
  DeckModel::AtNodes *
  DeckReader::at_nodes(std::vector<DeckModel::AtNodes> &list, const std::string &target)
  {
    for (DeckModel::AtNodes &one : list)
      if (upper_case(one.target) == upper_case(target))
        return &one;
    DeckModel::AtNodes one;
    const AbaqusSet   *set = model.deck.nodes.find(target);
    one.target             = set ? set->name : target;
    model.deck.nodes.append(in, target, one.nodes);
    for (const unsigned int node : one.nodes)
      if (transformed.count(node) > 0)
        {
          leave_out("on nodes whose axes *TRANSFORM turns");
          model.lacks_restraint |= in.keyword() == "BOUNDARY";
          return nullptr;
        }
    list.push_back(one);
    return &list.back();
  }



  void
  DeckReader::read_boundary()
  {
    if (!counts())
      return;
    if (in_step && upper_case(in.value("OP")) == "NEW")
      leave_out("its OP=NEW; supports of earlier steps stay");
    for (const std::string type : {"FIXED", "USER", "SUBMODEL"})
      if (in.has(type))
        {
          leave_out(type);
          return;
        }
    for (Words words; in.next_line(words);)
      {
        if (words.size() > 1 && !words[1].empty() && !std::isdigit(words[1][0]))
          {
            add_symmetry(words[0], upper_case(words[1]));
            continue;
          }
        const unsigned int first = component(words, 1),
                           last =
                             words.size() > 2 && !words[2].empty() ? component(words, 2) : first;
        if (last > 3)
          model.leave_out("*BOUNDARY of rotations and temperatures", in.place());
        if (first < 1 || first > 3)
          continue;
        if (DeckModel::AtNodes *nodes = at_nodes(model.supports, words[0]))
          for (unsigned int d = first; d <= std::min(last, 3u); ++d)
            set(nodes->components[d - 1], number(words, 3));
      }
  }



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
      leave_out("type " + kind);
    else if (DeckModel::AtNodes *nodes = at_nodes(model.supports, target))
      for (const unsigned int d : found->second)
        set(nodes->components[d], 0.);
  }



  void
  DeckReader::read_forces()
  {
    if (!counts())
      return;
    std::vector<Curve *> curves;
    for (auto &one : model.forces)
      for (Curve &curve : one.components)
        curves.push_back(&curve);
    remove_old(curves);
    for (Words words; in.next_line(words);)
      {
        const unsigned int d = component(words, 1);
        if (d < 1 || d > 3)
          model.leave_out("*CLOAD of moments and fluxes", in.place());
        else if (DeckModel::AtNodes *nodes = at_nodes(model.forces, words[0]))
          {
            // Forces of one step on the same node add up.
            Curve       &curve = nodes->components[d - 1];
            const double there =
              !curve.empty() && in_step && curve.back().step == model.steps.size() ?
                curve.back().value :
                0;
            set(curve, there + number(words, 2));
          }
      }
  }



  void
  DeckReader::read_element_loads()
  {
    ++n_element_loads;
    if (!counts())
      return;
    std::vector<Curve *> curves;
    for (auto &one : model.pressures)
      curves.push_back(&one.pressure);
    for (auto &one : model.body_loads)
      curves.push_back(&one.size);
    remove_old(curves);
    std::vector<double> values; // in the order of the surfaces that the mesh reader makes
    for (Words words; in.next_line(words);)
      {
        const std::string label = words.size() > 1 ? upper_case(words[1]) : "";
        if (is_pressure_label(label))
          {
            const double value = number(words, 2);
            if (std::find(values.begin(), values.end(), value) == values.end())
              {
                values.push_back(value);
                add_pressure(name_of_loaded_faces(n_element_loads, values.size()), value);
              }
            continue;
          }
        Members elements;
        model.deck.elements.append(in, words[0], elements);
        add_gravity(elements, words);
      }
  }



  /// A later step may change the pressure on the same faces.
  void
  DeckReader::add_pressure(const std::string &surface, const double value)
  {
    const auto faces_of = [&](const std::string &name) {
      std::set<MeshFile::Nodes> faces;
      for (const auto &group : model.deck.mesh.groups)
        if (upper_case(group.name) == upper_case(name))
          for (MeshFile::Nodes face : group.faces)
            {
              std::sort(face.begin(), face.end());
              faces.insert(face);
            }
      return faces;
    };
    const auto faces = faces_of(surface);
    for (DeckModel::FaceLoad &other : model.pressures)
      {
        const auto others = faces_of(other.surface);
        if (others == faces)
          return set(other.pressure, value);
        if (std::any_of(faces.begin(), faces.end(), [&](const auto &face) {
              return others.count(face) > 0;
            }))
          leave_out("in place of others on a part of the same faces; all act together");
      }
    model.pressures.push_back({surface, {}});
    set(model.pressures.back().pressure, value);
  }



  void
  DeckReader::add_gravity(const Members &elements, const Words &words)
  {
    const std::string   label = words.size() > 1 ? upper_case(words[1]) : "";
    DeckModel::BodyLoad load{elements, {{0, 0, 0}}, label == "GRAV", {}};
    if (label == "GRAV")
      {
        const double x = number(words, 3), y = number(words, 4), z = number(words, 5);
        const double n = std::sqrt(x * x + y * y + z * z);
        if (n == 0)
          in.fail("*DLOAD, GRAV needs a direction");
        load.direction = {{x / n, y / n, z / n}};
      }
    else if (label == "BX" || label == "BY" || label == "BZ")
      load.direction[label[1] - 'X'] = 1;
    else
      {
        leave_out("type " + label);
        return;
      }
    set(load.size, number(words, 2));
    model.body_loads.push_back(load);
  }



  void
  DeckReader::read_surface_loads()
  {
    if (!counts())
      return;
    std::vector<Curve *> curves;
    for (auto &one : model.pressures)
      curves.push_back(&one.pressure);
    remove_old(curves);
    for (Words words; in.next_line(words);)
      if (words.size() > 1 && upper_case(words[1]) == "P")
        {
          add_pressure(words[0], number(words, 2));
        }
      else
        leave_out("type " + (words.size() > 1 ? upper_case(words[1]) : ""));
  }



  void
  DeckReader::read_transform()
  {
    Members nodes;
    model.deck.nodes.append(in, in.value("NSET"), nodes);
    transformed.insert(nodes.begin(), nodes.end());
  }



  void
  DeckReader::read_initial_conditions()
  {
    if (upper_case(in.value("TYPE")) != "TEMPERATURE")
      {
        leave_out("bodies are at rest and without stress at the start");
        return;
      }
    read_temperatures_of_nodes(model.initial_temperatures);
  }



  void
  DeckReader::read_temperatures()
  {
    if (!counts())
      return;
    for (const std::string where : {"FILE", "USER", "SUBMODEL"})
      if (in.has(where))
        {
          leave_out("from " + where);
          return;
        }
    DeckModel::Temperatures &here = model.temperatures[in_step ? model.steps.size() : 0];
    here.amplitude                = upper_case(in.value("AMPLITUDE"));
    read_temperatures_of_nodes(here.of_nodes);
  }



  void
  DeckReader::read_temperatures_of_nodes(std::map<unsigned int, double> &of_nodes)
  {
    for (Words words; in.next_line(words);)
      {
        Members nodes;
        model.deck.nodes.append(in, words[0], nodes);
        for (const unsigned int node : nodes)
          of_nodes[node] = number(words, 1);
      }
  }
} // namespace Signorini
