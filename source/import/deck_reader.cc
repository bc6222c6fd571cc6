#include <signorini/import/deck_reader.h>
#include <signorini/mesh/formats/abaqus_elements.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  // The registry: one line a keyword. Output and what describes the mesh has no effect here.
  const std::map<std::string, void (DeckReader::*)()> DeckReader::registry = {
    {"PART", &DeckReader::begin_part},
    {"END PART", &DeckReader::end_part},
    {"MATERIAL", &DeckReader::begin_material},
    {"ELASTIC", &DeckReader::read_elastic},
    {"DENSITY", &DeckReader::read_density},
    {"SOLID SECTION", &DeckReader::read_section},
    {"AMPLITUDE", &DeckReader::read_amplitude},
    {"STEP", &DeckReader::begin_step},
    {"STATIC", &DeckReader::read_static},
    {"DYNAMIC", &DeckReader::read_quasi_static},
    {"MODAL DYNAMIC", &DeckReader::read_quasi_static},
    {"VISCO", &DeckReader::read_quasi_static},
    {"COUPLED TEMPERATURE-DISPLACEMENT", &DeckReader::read_quasi_static},
    {"UNCOUPLED TEMPERATURE-DISPLACEMENT", &DeckReader::read_quasi_static},
    {"FREQUENCY", &DeckReader::skip_step},
    {"COMPLEX FREQUENCY", &DeckReader::skip_step},
    {"BUCKLE", &DeckReader::skip_step},
    {"STEADY STATE DYNAMICS", &DeckReader::skip_step},
    {"HEAT TRANSFER", &DeckReader::skip_step},
    {"SENSITIVITY", &DeckReader::skip_step},
    {"GREEN", &DeckReader::skip_step},
    {"END STEP", &DeckReader::end_step},
    {"BOUNDARY", &DeckReader::read_boundary},
    {"CLOAD", &DeckReader::read_forces},
    {"DLOAD", &DeckReader::read_element_loads},
    {"DSLOAD", &DeckReader::read_surface_loads},
    {"TRANSFORM", &DeckReader::read_transform},
    {"SURFACE INTERACTION", &DeckReader::begin_interaction},
    {"SURFACE BEHAVIOR", &DeckReader::read_behaviour},
    {"CONTACT PAIR", &DeckReader::read_pairs},
    {"HEADING", &DeckReader::ignore},
    {"PREPRINT", &DeckReader::ignore},
    {"NODE", &DeckReader::ignore},
    {"ELEMENT", &DeckReader::ignore},
    {"NSET", &DeckReader::ignore},
    {"ELSET", &DeckReader::ignore},
    {"SURFACE", &DeckReader::ignore},
    {"NGEN", &DeckReader::ignore},
    {"NFILL", &DeckReader::ignore},
    {"NCOPY", &DeckReader::ignore},
    {"ELGEN", &DeckReader::ignore},
    {"ELCOPY", &DeckReader::ignore},
    {"SYSTEM", &DeckReader::ignore},
    {"ASSEMBLY", &DeckReader::ignore},
    {"END ASSEMBLY", &DeckReader::ignore},
    {"INSTANCE", &DeckReader::ignore},
    {"END INSTANCE", &DeckReader::ignore},
    {"NODE PRINT", &DeckReader::ignore},
    {"NODE FILE", &DeckReader::ignore},
    {"NODE OUTPUT", &DeckReader::ignore},
    {"EL PRINT", &DeckReader::ignore},
    {"EL FILE", &DeckReader::ignore},
    {"ELEMENT OUTPUT", &DeckReader::ignore},
    {"CONTACT PRINT", &DeckReader::ignore},
    {"CONTACT FILE", &DeckReader::ignore},
    {"CONTACT OUTPUT", &DeckReader::ignore},
    {"ENERGY OUTPUT", &DeckReader::ignore},
    {"SECTION PRINT", &DeckReader::ignore},
    {"FILE FORMAT", &DeckReader::ignore},
    {"OUTPUT", &DeckReader::ignore},
    {"PRINT", &DeckReader::ignore},
    {"MONITOR", &DeckReader::ignore},
    {"RESTART", &DeckReader::ignore},
    {"TIME POINTS", &DeckReader::ignore},
    {"CONTROLS", &DeckReader::ignore},
    {"NO ANALYSIS", &DeckReader::ignore},
    {"CONDUCTIVITY", &DeckReader::ignore},
    {"SPECIFIC HEAT", &DeckReader::ignore},
    {"PHYSICAL CONSTANTS", &DeckReader::ignore}};

  /// Why some keywords are left out. All others that are not in the registry are left out too.
  const std::map<std::string, std::string> DeckReader::not_modelled = {
    {"FRICTION", "contact is without friction"},
    {"CHANGE FRICTION", "contact is without friction"},
    {"PLASTIC", "materials are linear elastic"},
    {"CREEP", "materials are linear elastic"},
    {"EXPANSION", "thermal strain"},
    {"TEMPERATURE", "thermal strain"},
    {"INITIAL CONDITIONS", "bodies are at rest and without stress at the start"},
    {"EQUATION", "nodes are not tied to each other by equations"},
    {"MPC", "nodes are not tied to each other by equations"},
    {"COUPLING", "nodes are not tied to each other by equations"},
    {"KINEMATIC", "nodes are not tied to each other by equations"},
    {"RIGID BODY", "bodies that are meshed are elastic"},
    {"TIE", "surfaces are not tied"},
    {"CYCLIC SYMMETRY MODEL", "cyclic symmetry"},
    {"PRE-TENSION SECTION", "pre-tension"},
    {"MODEL CHANGE", "all elements and contact pairs are there at all times"},
    {"CLEARANCE", "gaps are those of the mesh"},
    {"SHELL SECTION", "solids alone have stiffness"},
    {"BEAM SECTION", "solids alone have stiffness"},
    {"MEMBRANE SECTION", "solids alone have stiffness"},
    {"SPRING", "solids alone have stiffness"},
    {"MASS", "inertia"},
    {"DAMPING", "inertia"},
    {"CONTACT DAMPING", "inertia"}};



  DeckReader::DeckReader(const std::string &file_name)
    : in(file_name)
  {
    model.deck = read_abaqus_deck(file_name);
  }



  DeckModel
  DeckReader::read()
  {
    while (in.next_keyword())
      {
        const auto found = registry.find(in.keyword());
        if (found != registry.end())
          (this->*found->second)();
        else
          {
            const auto why = not_modelled.find(in.keyword());
            leave_out(why == not_modelled.end() ? "not known here" : why->second);
          }
      }
    return std::move(model);
  }



  void
  DeckReader::ignore()
  {}



  void
  DeckReader::leave_out(const std::string &why)
  {
    model.leave_out("*" + in.keyword() + " (" + why + ")", in.place());
  }



  void
  DeckReader::begin_part()
  {
    part = upper_case(in.value("NAME"));
  }



  void
  DeckReader::end_part()
  {
    part.clear();
  }



  void
  DeckReader::begin_material()
  {
    material                       = upper_case(in.value("NAME"));
    model.materials[material].name = in.value("NAME");
  }



  double
  DeckReader::number(const Words &words, const unsigned int i) const
  {
    return i < words.size() ? real_from(in, words[i]) : 0.;
  }



  /// Of anisotropic ones, the isotropic part of the first constants.
  void
  DeckReader::read_elastic()
  {
    DeckModel::Material &one  = model.materials[material];
    const std::string    type = upper_case(in.value("TYPE"));
    Words                words, more;
    if (!in.next_line(words))
      in.fail("*ELASTIC without data");
    const double a = number(words, 0), b = number(words, 1), d = number(words, 3);
    if (type.empty() || type == "ISO" || type == "ISOTROPIC")
      {
        one.youngs_modulus = a;
        one.poissons_ratio = b;
        if (in.next_line(more))
          leave_out("its dependence on temperature; the first line counts");
        return;
      }
    if (type == "ORTHO" || type == "ORTHOTROPIC" || type == "ANISO" || type == "ANISOTROPIC")
      {
        one.poissons_ratio = b / (a + b);
        one.youngs_modulus = a * (1 + b / (a + b)) * (1 - 2 * b / (a + b));
      }
    else
      {
        one.youngs_modulus = a;
        one.poissons_ratio = d;
      }
    leave_out("its TYPE=" + type + "; the first constants are taken as isotropic");
  }



  void
  DeckReader::read_density()
  {
    Words words;
    if (in.next_line(words))
      model.materials[material].density = number(words, 0);
  }



  void
  DeckReader::read_section()
  {
    DeckModel::SolidSection section;
    section.material = upper_case(in.value("MATERIAL"));
    std::vector<std::string> instances{""};
    if (!part.empty())
      instances = model.deck.instances_of[part];
    const std::string of = in.value("ELSET");
    for (const std::string &instance : instances)
      model.deck.elements.append(in, of, section.elements, instance);
    if (in.has("ORIENTATION"))
      leave_out("its ORIENTATION");
    Words words;
    if (in.next_line(words))
      section.thickness = number(words, 0);
    model.sections.push_back(section);
  }



  void
  DeckReader::read_amplitude()
  {
    const std::string definition = upper_case(in.value("DEFINITION"));
    if (!definition.empty() && definition != "TABULAR")
      {
        leave_out("its DEFINITION=" + definition + "; what refers to it is ramped");
        return;
      }
    if (in.has("TIME") && upper_case(in.value("TIME")) != "STEP TIME")
      leave_out("its TIME; it counts from the beginning of each step");
    DeckModel::Points  &points = model.amplitudes[upper_case(in.value("NAME"))];
    std::vector<double> values;
    for (Words words; in.next_line(words);)
      for (const std::string &word : words)
        if (!word.empty())
          values.push_back(real_from(in, word));
    for (unsigned int i = 0; i + 1 < values.size(); i += 2)
      points.emplace_back(values[i], values[i + 1]);
  }



  void
  DeckReader::begin_step()
  {
    in_step     = true;
    step_counts = !in.has("PERTURBATION");
    if (in.has("NLGEOM") && upper_case(in.value("NLGEOM")) != "NO")
      model.leave_out("*STEP, NLGEOM (strains and rotations are small)", in.place());
    if (in.has("PERTURBATION"))
      model.leave_out("*STEP, PERTURBATION (the whole step)", in.place());
    if (step_counts)
      {
        const double begin = model.steps.empty() ? 0. : model.steps.back().end;
        model.steps.push_back({begin, begin + 1});
      }
  }



  void
  DeckReader::read_static()
  {
    Words words;
    if (step_counts && in.next_line(words) && number(words, 1) > 0)
      model.steps.back().end = model.steps.back().begin + number(words, 1);
  }



  void
  DeckReader::read_quasi_static()
  {
    leave_out("what depends on velocities and temperatures; its loads are static");
    read_static();
  }



  void
  DeckReader::skip_step()
  {
    leave_out("the whole step");
    if (step_counts)
      model.steps.pop_back();
    step_counts = false;
  }



  void
  DeckReader::end_step()
  {
    in_step = false;
  }



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
        const unsigned int first = number(words, 1),
                           last  = words.size() > 2 && !words[2].empty() ? number(words, 2) : first;
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
        const unsigned int component = number(words, 1);
        if (component < 1 || component > 3)
          model.leave_out("*CLOAD of moments and fluxes", in.place());
        else if (DeckModel::AtNodes *nodes = at_nodes(model.forces, words[0]))
          {
            // Forces of one step on the same node add up.
            Curve       &curve = nodes->components[component - 1];
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
    const std::string   label = upper_case(words.at(1));
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
  DeckReader::begin_interaction()
  {
    interaction = upper_case(in.value("NAME"));
    model.interactions[interaction];
  }



  void
  DeckReader::read_behaviour()
  {
    if (in_step)
      {
        leave_out("its change in a step");
        return;
      }
    using Kind                   = DeckModel::Interaction::Kind;
    const std::string       kind = upper_case(in.value("PRESSURE-OVERCLOSURE"));
    DeckModel::Interaction &one  = model.interactions[interaction];
    if (kind == "LINEAR" || kind == "TIED")
      {
        Words words;
        one.kind = kind == "TIED" ? Kind::tied : Kind::linear;
        if (in.next_line(words))
          one.stiffness = number(words, 0);
        if (kind == "LINEAR" && !(one.stiffness > 0))
          in.fail("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR needs a positive slope");
        if (kind == "TIED")
          leave_out("tied tangentially: the surfaces stay together, but slide freely");
        return;
      }
    one.kind = Kind::hard;
    if (!kind.empty() && kind != "HARD")
      leave_out(kind + "; contact is hard");
    if (in.has("NO SEPARATION"))
      {
        one.kind = Kind::tied;
        leave_out("NO SEPARATION; the surfaces stay together from the beginning");
      }
  }



  void
  DeckReader::read_pairs()
  {
    if (in.has("ADJUST"))
      leave_out("its ADJUST; gaps are those of the mesh");
    if (in.has("TIED"))
      leave_out("its TIED tangentially: the surfaces stay together, but slide freely");
    for (Words words; in.next_line(words);)
      if (words.size() < 2 || words[1].empty())
        leave_out("of one surface with itself: " + words[0]);
      else
        model.pairs.push_back(
          {words[0], words[1], in.has("TIED") ? "\"TIED" : upper_case(in.value("INTERACTION"))});
    if (in.has("TIED"))
      model.interactions["\"TIED"].kind = DeckModel::Interaction::Kind::tied;
  }



  DeckModel
  read_deck_model(const std::string &file_name)
  {
    return DeckReader(file_name).read();
  }
} // namespace Signorini
