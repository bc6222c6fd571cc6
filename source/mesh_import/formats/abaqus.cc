// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_reader.h"
#include "mesh_import/import_steps.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // One line for each keyword that defines nodes, elements or sets, or that is rejected because it
  // would. Keywords that are not in this table do not influence the mesh and are skipped.
  const std::map<std::string, void (AbaqusReader::*)(), IgnoringBlanks> AbaqusReader::registry = {
    {"NODE", &AbaqusReader::read_nodes},
    {"ELEMENT", &AbaqusReader::read_elements},
    {"NSET", &AbaqusReader::read_node_set},
    {"ELSET", &AbaqusReader::read_element_set},
    {"SURFACE", &AbaqusReader::read_surface},
    {"DLOAD", &AbaqusReader::read_element_loads},
    {"CONTACT PAIR", &AbaqusReader::read_adjustments},
    {"PRE-TENSION SECTION", &AbaqusReader::read_section_of_bolt},
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
    {"STEP", &AbaqusReader::begin_step},
    {"MODEL CHANGE", &AbaqusReader::read_model_change},
    {"SUBSTRUCTURE PATH", &AbaqusReader::refuse},
    {"IMPORT", &AbaqusReader::refuse}};



  AbaqusReader::AbaqusReader(const std::string &file_name)
    : in(file_name)
  {
    whole.mesh = std::make_shared<MeshFile>();
  }



  // The file is read once, from the first to the last line. Sets and surfaces may refer to what is
  // defined below them: these references are stored and resolved at the end of their scope. Nodes
  // are adjusted at the very end, when all surfaces are known.
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
    // The order of these steps matters: groups are made of complete sets, adjustments move nodes of
    // complete surfaces, and only then the tables of numbers may be moved into the deck.
    complete_scope();
    make_groups();
    for (const Adjustment &one : adjustments)
      adjust(one);
    for (const std::string &section : sections_of_bolts)
      cut(section);
    note_of_other_elements();
    remove_elements();
    whole.mesh->notes.assign(notes.begin(), notes.end());
    whole.mesh->numbers = whole.nodes.all_numbers();
    deck.mesh           = std::move(*whole.mesh);
    deck.nodes          = std::move(whole.nodes);
    deck.elements       = std::move(whole.elements);
    return std::move(deck);
  }



  void
  AbaqusReader::read_section_of_bolt()
  {
    if (in.has("SURFACE"))
      sections_of_bolts.push_back(in.value("SURFACE"));
  }



  // The nodes on both sides of a section are different ones. The copies have the next free numbers,
  // and are in the sets of the nodes that they were made of.
  void
  AbaqusReader::cut(const std::string &section)
  {
    std::map<unsigned int, unsigned int> copies;
    try
      {
        copies = cut_mesh(*whole.mesh, section, other_side_of(section));
      }
    catch (const SceneError &error)
      {
        in.fail(error.what());
      }
    std::size_t last = 0;
    for (const auto &[number, node] : whole.nodes.numbers())
      last = std::max(last, number);
    for (const auto &[node, copy] : copies)
      whole.nodes.insert(++last, copy);
    std::vector<std::string> names;
    for (const auto &[name, set] : whole.nodes.all())
      names.push_back(name);
    for (const std::string &name : names)
      {
        Members      &members = whole.nodes.get(name).members;
        const Members before  = members;
        for (const unsigned int node : before)
          if (const auto copy = copies.find(node); copy != copies.end())
            members.push_back(copy->second);
      }
    notes.insert("the mesh is cut along '" + section +
                 "', since *PRE-TENSION SECTION names it; its other side is called '" +
                 other_side_of(section) + "'");
  }



  void
  AbaqusReader::begin_step()
  {
    complete_scope();
    ++n_steps;
  }



  void
  AbaqusReader::read_model_change()
  {
    if (upper_case(in.value("TYPE")) != "ELEMENT")
      return;
    changes_later = changes_later || n_steps != 1 || !in.has("REMOVE");
    for (Words words; in.next_line(words);)
      removed.insert(removed.end(), words.begin(), words.end());
  }



  // Elements that are there in no step are no cells, but points, which have no volume. Those that
  // come or go in a later step stay.
  void
  AbaqusReader::remove_elements()
  {
    if (removed.empty() || changes_later)
      return;
    Members elements;
    for (const std::string &word : removed)
      whole.elements.append(in, word, elements);
    for (const unsigned int e : elements)
      {
        whole.mesh->elements[e].shape = MeshFile::Shape::point;
        deck.removed_elements.insert(e);
      }
    notes.insert(std::to_string(deck.removed_elements.size()) +
                 " elements are left out, since *MODEL CHANGE removes them in the first step");
  }



  void
  AbaqusReader::refuse()
  {
    in.fail("*" + in.keyword() +
            " is not read here; write out the nodes and elements that it makes");
  }



  // The set is created if there is none of that name. Without the parameter there is no set, and
  // the result is null.
  AbaqusSet *
  AbaqusReader::set_of(const std::string &parameter, AbaqusSets &sets)
  {
    return in.value(parameter).empty() ? nullptr : &sets.get(in.value(parameter));
  }



  // Data lines: number, up to three coordinates; in Cartesian, cylindrical or spherical coordinates
  // (SYSTEM=R, C, S), of the local system of *SYSTEM.
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
        // SYSTEM of *NODE describes the kind of coordinates within the local system; that local
        // system itself, from *SYSTEM, is then moved to its place.
        x = cartesian(x, coordinate);
        add_node(number_from(in, words[0]), system ? (*system)(x) : x, set);
      }
  }



  // Cylindrical: radius, angle, height. Spherical: radius, longitude, latitude. Angles in degrees.
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



  // A node that is defined again gets the new position.
  void
  AbaqusReader::add_node(const std::size_t number, const Point<3> &place, AbaqusSet *set)
  {
    // insert() returns whether the number is new; only then a node is appended.
    if (scope->nodes.insert(number, scope->mesh->nodes.size()))
      scope->mesh->nodes.emplace_back();
    const unsigned int node  = scope->nodes.index(number);
    scope->mesh->nodes[node] = place;
    scope->number_of[node]   = number;
    if (set)
      set->members.push_back(node);
  }



  // Data lines: number, nodes. The nodes of one element may continue on further lines. Where their
  // number is unknown (springs and the like), a line that ends with a comma continues.
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
        // Without a known number of nodes the end of the line decides, unless it ends with a comma.
        const bool complete =
          type.n_nodes > 0 ? numbers.size() > type.n_nodes : !in.has_continuation();
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



  // Elements of lines and points may lack nodes; they have no stiffness here, and only nodes that
  // exist are kept.
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
    if (members.size() + 1 < numbers.size())
      scope->late_elements.push_back(
        {static_cast<unsigned int>(elements.size()), type, {numbers.begin() + 1, numbers.end()}});
    // An element with too few nodes for its shape is kept as a point, so that its number and its
    // sets stay valid.
    const bool lacks_nodes = members.size() < n_corners(type.shape);
    elements.push_back({lacks_nodes ? MeshFile::Shape::point : type.shape,
                        type_name,
                        numbers[0],
                        reordered(type, members)});
  }



  /// Report elements of lower dimension than the solids, such as springs and shells, which have no
  /// stiffness here.
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



  std::string
  other_side_of(const std::string &section)
  {
    return section + " other side";
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
