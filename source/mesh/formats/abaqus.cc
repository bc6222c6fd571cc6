#include <signorini/mesh/formats/abaqus_reader.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // The registry: one line a keyword. Those that are not here say nothing about the mesh.
  const std::map<std::string, void (AbaqusReader::*)()> AbaqusReader::registry = {
    {"NODE", &AbaqusReader::read_nodes},
    {"ELEMENT", &AbaqusReader::read_elements},
    {"NSET", &AbaqusReader::read_node_set},
    {"ELSET", &AbaqusReader::read_element_set},
    {"SURFACE", &AbaqusReader::read_surface},
    {"DLOAD", &AbaqusReader::read_element_loads},
    {"SYSTEM", &AbaqusReader::read_system},
    {"PART", &AbaqusReader::begin_part},
    {"END PART", &AbaqusReader::end_scope},
    {"INSTANCE", &AbaqusReader::begin_instance},
    {"END INSTANCE", &AbaqusReader::end_instance},
    {"NGEN", &AbaqusReader::generate_nodes},
    {"NFILL", &AbaqusReader::fill_nodes},
    {"NCOPY", &AbaqusReader::copy_nodes},
    {"ELGEN", &AbaqusReader::generate_elements},
    {"ELCOPY", &AbaqusReader::copy_elements},
    {"NMAP", &AbaqusReader::refuse},
    {"SUBSTRUCTURE PATH", &AbaqusReader::refuse},
    {"IMPORT", &AbaqusReader::refuse}};



  AbaqusReader::AbaqusReader(const std::string &file_name)
    : in(file_name)
  {
    whole.mesh = std::make_shared<MeshFile>();
  }



  AbaqusDeck
  AbaqusReader::read()
  {
    while (in.next_keyword())
      if (const auto found = registry.find(in.keyword()); found != registry.end())
        (this->*found->second)();
    if (scope != &whole)
      in.fail("a part or an instance is without its end: *END PART, *END INSTANCE");
    if (whole.mesh->elements.empty())
      in.fail(parts.empty() ? "the file has no elements: *ELEMENT" :
                              "the file has parts, but no elements in instances: *INSTANCE");
    make_groups();
    note_of_other_elements();
    whole.mesh->notes.assign(notes.begin(), notes.end());
    whole.mesh->numbers = whole.nodes.all_numbers();
    deck.mesh           = std::move(*whole.mesh);
    deck.nodes          = std::move(whole.nodes);
    deck.elements       = std::move(whole.elements);
    return std::move(deck);
  }



  void
  AbaqusReader::refuse()
  {
    in.fail("*" + in.keyword() +
            " is not read here; write out the nodes and elements that it makes");
  }



  AbaqusSet *
  AbaqusReader::set_of(const std::string &parameter, AbaqusSets &sets)
  {
    return in.value(parameter).empty() ? nullptr : &sets.get(in.value(parameter));
  }



  void
  AbaqusReader::read_nodes()
  {
    if (scope == &instance)
      in.fail("*NODE within an instance is not read here; write the nodes in the part");
    AbaqusSet *const  set        = set_of("NSET", scope->nodes);
    const std::string coordinate = upper_case(in.value("SYSTEM"));
    for (Words words; in.next_line(words);)
      {
        Point<3> x;
        for (unsigned int d = 0; d < 3; ++d)
          x[d] = d + 1 < words.size() ? real_from(in, words[d + 1]) : 0.;
        x = cartesian(x, coordinate);
        add_node(number_from(in, words[0]), system ? (*system)(x) : x, set);
      }
  }



  Point<3>
  AbaqusReader::cartesian(const Point<3> x, const std::string &coordinates) const
  {
    const double degree = numbers::PI / 180, a = x[1] * degree, b = x[2] * degree;
    if (coordinates.empty() || coordinates == "R")
      return x;
    if (coordinates == "C")
      return {x[0] * std::cos(a), x[0] * std::sin(a), x[2]};
    if (coordinates == "S")
      return {x[0] * std::cos(a) * std::cos(b),
              x[0] * std::sin(a) * std::cos(b),
              x[0] * std::sin(b)};
    in.fail("*NODE, SYSTEM=" + coordinates + ": R, C and S are known");
  }



  void
  AbaqusReader::add_node(const std::size_t number, const Point<3> &place, AbaqusSet *set)
  {
    if (scope->nodes.insert(number, scope->mesh->nodes.size()))
      scope->mesh->nodes.emplace_back();
    const unsigned int node  = scope->nodes.index(number);
    scope->mesh->nodes[node] = place;
    scope->number_of[node]   = number;
    if (set)
      set->members.push_back(node);
  }



  void
  AbaqusReader::read_elements()
  {
    const std::string type_name = upper_case(in.value("TYPE"));
    if (type_name.empty())
      in.fail("*ELEMENT needs TYPE=...");
    if (scope == &instance)
      in.fail("*ELEMENT within an instance is not read here; write the elements in the part");
    const AbaqusType         type = abaqus_type(type_name);
    AbaqusSet *const         set  = set_of("ELSET", scope->elements);
    std::vector<std::size_t> numbers;
    for (Words words; in.next_line(words);)
      {
        for (const std::string &word : words)
          if (!word.empty())
            // Elements of the assembly refer to nodes of instances; no solid does.
            numbers.push_back(
              numbers.empty() || word.find('.') == std::string::npos ? number_from(in, word) : 0);
        const bool complete = type.n_nodes > 0 ? numbers.size() > type.n_nodes : !in.goes_on();
        if (complete)
          {
            add_element(type, type_name, numbers, set);
            numbers.clear();
          }
      }
    if (!numbers.empty())
      in.fail("element " + std::to_string(numbers[0]) + " of type " + type_name +
              " is without its " + std::to_string(type.n_nodes) + " nodes");
  }



  void
  AbaqusReader::add_element(const AbaqusType               &type,
                            const std::string              &type_name,
                            const std::vector<std::size_t> &numbers,
                            AbaqusSet                      *set)
  {
    if (numbers.empty() || (type.n_nodes > 0 && numbers.size() != type.n_nodes + 1))
      in.fail("an element of type " + type_name + " does not have its " +
              std::to_string(type.n_nodes) + " nodes");
    MeshFile::Nodes members;
    for (unsigned int i = 1; i < numbers.size(); ++i)
      {
        const unsigned int node = scope->nodes.index(numbers[i]);
        // Springs to the ground and the like may have a node 0 or none.
        if (node == AbaqusSets::none && type.n_nodes > 0)
          in.fail("element " + std::to_string(numbers[0]) + " has the unknown node " +
                  std::to_string(numbers[i]));
        if (node != AbaqusSets::none)
          members.push_back(node);
      }
    std::vector<MeshFile::Element> &elements = scope->mesh->elements;
    if (!scope->elements.insert(numbers[0], elements.size()))
      in.fail("element " + std::to_string(numbers[0]) + " is there twice");
    if (set)
      set->members.push_back(elements.size());
    const bool lacks_nodes = members.size() < n_corners(type.shape);
    elements.push_back({lacks_nodes ? MeshFile::Shape::point : type.shape,
                        type_name,
                        numbers[0],
                        reordered(type, members)});
  }



  void
  AbaqusReader::read_node_set()
  {
    if (in.value("NSET").empty())
      in.fail("*NSET needs NSET=name");
    Members members;
    if (in.has("ELSET"))
      members = nodes_of(in.value("ELSET"));
    scope->nodes.append_lines(in, members);
    AbaqusSet &set = scope->nodes.get(in.value("NSET"));
    set.members.insert(set.members.end(), members.begin(), members.end());
  }



  void
  AbaqusReader::read_element_set()
  {
    if (in.value("ELSET").empty())
      in.fail("*ELSET needs ELSET=name");
    Members members;
    scope->elements.append_lines(in, members);
    AbaqusSet &set = scope->elements.get(in.value("ELSET"));
    set.members.insert(set.members.end(), members.begin(), members.end());
  }



  AbaqusReader::Members
  AbaqusReader::nodes_of(const std::string &element_set) const
  {
    Members members;
    scope->elements.append(in, element_set, members, in.value("INSTANCE"));
    std::set<unsigned int> result;
    for (const unsigned int e : members)
      result.insert(scope->mesh->elements[e].nodes.begin(), scope->mesh->elements[e].nodes.end());
    return {result.begin(), result.end()};
  }



  /// Other kinds than the two are not made of the mesh: analytical rigid surfaces.
  void
  AbaqusReader::read_surface()
  {
    const std::string type = in.has("TYPE") ? upper_case(in.value("TYPE")) : "ELEMENT";
    if (type != "ELEMENT" && type != "NODE")
      return;
    if (in.value("NAME").empty())
      in.fail("*SURFACE needs NAME=name");
    if (in.has("COMBINE"))
      {
        scope->surfaces.push_back(combined_surface(upper_case(in.value("COMBINE"))));
        return;
      }
    MeshFile::Group   surface{in.value("NAME"), {}, {}, {}};
    const std::string of = in.value("INSTANCE");
    for (Words words; in.next_line(words);)
      if (type == "NODE")
        scope->nodes.append(in, words[0], surface.nodes, of);
      else
        add_faces((of.empty() || words[0].empty() ? "" : of + ".") + words[0],
                  words.size() > 1 ? upper_case(words[1]) : "",
                  surface);
    scope->surfaces.push_back(surface);
  }



  MeshFile::Group
  AbaqusReader::combined_surface(const std::string &how)
  {
    if (how != "UNION")
      in.fail("*SURFACE, COMBINE=" + how + " is not read here; UNION is");
    MeshFile::Group result{in.value("NAME"), {}, {}, {}};
    for (Words words; in.next_line(words);)
      for (const std::string &word : words)
        if (!word.empty())
          {
            const auto found =
              std::find_if(scope->surfaces.begin(), scope->surfaces.end(), [&](const auto &other) {
                return upper_case(other.name) == upper_case(word);
              });
            if (found == scope->surfaces.end())
              in.fail("there is no surface '" + word + "' above");
            check_amount(in, double(result.faces.size()) + found->faces.size());
            check_amount(in, double(result.nodes.size()) + found->nodes.size());
            result.faces.insert(result.faces.end(), found->faces.begin(), found->faces.end());
            result.nodes.insert(result.nodes.end(), found->nodes.begin(), found->nodes.end());
          }
    return result;
  }



  /// No elements: all of the scope.
  void
  AbaqusReader::add_faces(const std::string &of, const std::string &label, MeshFile::Group &surface)
  {
    Members members;
    scope->elements.append(in, of, members);
    if (of.empty())
      for (const auto &[number, e] : scope->elements.numbers())
        members.push_back(e);
    check_amount(in, double(surface.faces.size()) + members.size());
    for (const unsigned int e : members)
      {
        const MeshFile::Element &element = scope->mesh->elements[e];
        const auto               faces   = abaqus_faces(element, label);
        surface.faces.insert(surface.faces.end(), faces.begin(), faces.end());
        if (faces.empty())
          notes.insert("surface " + surface.name + ": elements of type " + element.type +
                       " have no face " + label);
      }
  }



  bool
  is_pressure_label(const std::string &label)
  {
    return label.size() == 2 && label[0] == 'P' && label[1] >= '1' && label[1] <= '6';
  }



  std::string
  name_of_loaded_faces(const unsigned int n, const unsigned int k)
  {
    const std::string name = "DLOAD " + std::to_string(n);
    return k == 1 ? name : name + " " + std::to_string(k);
  }



  /// Faces that have a pressure of their own have no other name.
  void
  AbaqusReader::read_element_loads()
  {
    ++n_element_loads;
    std::vector<double>          pressures;
    std::vector<MeshFile::Group> loaded;
    for (Words words; in.next_line(words);)
      {
        const std::string label = words.size() > 1 ? upper_case(words[1]) : "";
        if (!is_pressure_label(label))
          continue;
        const double pressure = words.size() > 2 ? real_from(in, words[2]) : 0;
        const auto   found    = std::find(pressures.begin(), pressures.end(), pressure);
        const auto   k        = found - pressures.begin();
        if (found == pressures.end())
          {
            pressures.push_back(pressure);
            loaded.push_back({name_of_loaded_faces(n_element_loads, k + 1), {}, {}, {}});
          }
        add_faces(words[0], "S" + label.substr(1), loaded[k]);
      }
    whole.surfaces.insert(whole.surfaces.end(), loaded.begin(), loaded.end());
  }



  void
  AbaqusReader::make_groups()
  {
    MeshFile &file = *whole.mesh;
    for (const MeshFile::Group &one : instances)
      {
        if (const AbaqusSet *set = whole.elements.find(one.name);
            set && set->members != one.elements)
          in.fail("the element set '" + one.name + "' is called as an instance is");
        file.groups.push_back(one);
      }
    for (const MeshFile::Group &surface : whole.surfaces)
      {
        MeshFile::Group &group = file.group(surface.name);
        group.faces.insert(group.faces.end(), surface.faces.begin(), surface.faces.end());
        group.nodes.insert(group.nodes.end(), surface.nodes.begin(), surface.nodes.end());
      }
    for (const auto &[name, set] : whole.elements.all())
      file.group(set.name).elements = set.members;
    for (const auto &[name, set] : whole.nodes.all())
      {
        MeshFile::Nodes &members = file.group(set.name).nodes;
        members.insert(members.end(), set.members.begin(), set.members.end());
      }
  }



  /// What a deck computes with, but not this program.
  void
  AbaqusReader::note_of_other_elements()
  {
    std::map<std::string, unsigned int> others;
    unsigned int                        largest = 0;
    for (const auto &element : whole.mesh->elements)
      if (element.shape != MeshFile::Shape::unknown)
        largest = std::max(largest, dimension_of(element.shape));
    for (const auto &element : whole.mesh->elements)
      if (dimension_of(element.shape) < largest)
        ++others[element.type];
    for (const auto &[type, n] : others)
      notes.insert(std::to_string(n) + " elements of type " + type +
                   " are no solids: they have no stiffness here");
  }



  AbaqusDeck
  read_abaqus_deck(const std::string &file_name)
  {
    return AbaqusReader(file_name).read();
  }



  MeshFile
  read_abaqus(const std::string &file_name)
  {
    return read_abaqus_deck(file_name).mesh;
  }
} // namespace Signorini
