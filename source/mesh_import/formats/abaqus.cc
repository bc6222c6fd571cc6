// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_reader.h"
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
    {"STEP", &AbaqusReader::complete_scope},
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
    complete_scope();
    make_groups();
    for (const Adjustment &one : adjustments)
      adjust(one);
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
    read_members(scope->nodes, in.value("NSET"), members);
  }



  void
  AbaqusReader::read_element_set()
  {
    if (in.value("ELSET").empty())
      in.fail("*ELSET needs ELSET=name");
    read_members(scope->elements, in.value("ELSET"), {});
  }



  /// Read the data lines of *NSET or *ELSET. Members that are not defined so far are stored until
  /// the end of the scope.
  /// @param members indices that the set gets in any case
  void
  AbaqusReader::read_members(AbaqusSets &sets, const std::string &name, Members members)
  {
    const auto unknown = sets.append_lines(in, members);
    AbaqusSet &set     = sets.get(name);
    set.members.insert(set.members.end(), members.begin(), members.end());
    if (!unknown.empty())
      scope->late_members.push_back({&sets == &scope->nodes, name, unknown});
  }



  // The nodes of all elements of a set, for *NSET, ELSET=.
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



  /// Only surfaces of element faces and of nodes are made of the mesh; analytical rigid surfaces
  /// are skipped. The data lines are stored until the end of the scope.
  void
  AbaqusReader::read_surface()
  {
    const std::string type = in.has("TYPE") ? upper_case(in.value("TYPE")) : "ELEMENT";
    if (type != "ELEMENT" && type != "NODE")
      return;
    if (in.value("NAME").empty())
      in.fail("*SURFACE needs NAME=name");
    if (in.has("COMBINE") && upper_case(in.value("COMBINE")) != "UNION")
      in.fail("*SURFACE, COMBINE=" + in.value("COMBINE") + " is not read here; UNION is");
    LateSurface late{in.value("NAME"), type, in.has("COMBINE"), in.value("INSTANCE"), {}};
    for (Words words; in.next_line(words);)
      late.lines.emplace_back(words, in.position_in_messages());
    scope->late_surfaces.push_back(late);
  }



  // Resolve all stored references of this scope.
  void
  AbaqusReader::complete_scope()
  {
    complete_sets();
    for (const LateSurface &late : scope->late_surfaces)
      scope->surfaces.push_back(completed(late));
    scope->late_surfaces.clear();
  }



  /// Sets may contain each other in any order. A word is resolved once the set that it names has no
  /// open words itself; passes are repeated until none resolves anything, which ends because each
  /// pass with success removes at least one word. Words that are left (unknown names, or circular
  /// sets) are reported.
  void
  AbaqusReader::complete_sets()
  {
    for (bool has_found = true; has_found;)
      {
        has_found = false;
        for (LateMembers &late : scope->late_members)
          {
            AbaqusSets &sets = late.are_nodes ? scope->nodes : scope->elements;
            AbaqusSet  &set  = sets.get(late.set);
            // Whether a set of that name still waits for members itself. A set may name itself
            // without waiting.
            const auto is_open = [&](const std::string &word) {
              return std::any_of(scope->late_members.begin(),
                                 scope->late_members.end(),
                                 [&](const LateMembers &other) {
                                   return &other != &late && other.are_nodes == late.are_nodes &&
                                          !other.words.empty() &&
                                          upper_case(other.set) == upper_case(word);
                                 });
            };
            Words   unknown;
            Members found;
            for (const std::string &word : late.words)
              if (!is_open(word) && sets.append_if_known(word, found))
                has_found = true;
              else
                unknown.push_back(word);
            set.members.insert(set.members.end(), found.begin(), found.end());
            late.words = unknown;
          }
      }
    // What is left names nothing. Numbers without a node or an element are noted only; names that
    // do not exist are also listed as missing.
    for (const LateMembers &late : scope->late_members)
      for (const std::string &word : late.words)
        {
          const std::string note = (late.are_nodes ? "node set " : "element set ") + late.set +
                                   ": there is no '" + word + "'; it is left out";
          notes.insert(note);
          if (word.find_first_not_of("0123456789") != std::string::npos)
            deck.missing.push_back(note);
        }
    scope->late_members.clear();
  }



  // A surface is a union of others, a list of nodes and node sets, or a list of element sets with
  // face labels.
  MeshFile::Group
  AbaqusReader::completed(const LateSurface &late)
  {
    MeshFile::Group surface{late.name, {}, {}, {}};
    for (const auto &[words, place] : late.lines)
      if (late.is_union)
        for (const std::string &word : words)
          add_surface(word, place, surface);
      else if (late.type == "NODE")
        {
          if (!words[0].empty() &&
              !scope->nodes.append_if_known(words[0], surface.nodes, late.instance))
            throw SceneError(place + "there is no node or set of nodes '" + words[0] + "'");
        }
      else
        add_faces((late.instance.empty() || words[0].empty() ? "" : late.instance + ".") + words[0],
                  words.size() > 1 ? upper_case(words[1]) : "",
                  place,
                  surface);
    return surface;
  }



  // The surfaces above are complete already, since they are completed in the order of the file.
  void
  AbaqusReader::add_surface(const std::string &name,
                            const std::string &place,
                            MeshFile::Group   &to) const
  {
    if (name.empty())
      return;
    const auto found =
      std::find_if(scope->surfaces.begin(), scope->surfaces.end(), [&](const auto &other) {
        return upper_case(other.name) == upper_case(name);
      });
    if (found == scope->surfaces.end())
      throw SceneError(place + "there is no surface '" + name + "' above");
    check_amount(in, double(to.faces.size()) + found->faces.size());
    check_amount(in, double(to.nodes.size()) + found->nodes.size());
    to.faces.insert(to.faces.end(), found->faces.begin(), found->faces.end());
    to.nodes.insert(to.nodes.end(), found->nodes.begin(), found->nodes.end());
  }



  /// Add the faces with a label of an element or set; if `of` is empty, those of all elements of
  /// the scope. Elements without such a face are reported.
  /// @param place in the file, for messages
  void
  AbaqusReader::add_faces(const std::string &of,
                          const std::string &label,
                          const std::string &place,
                          MeshFile::Group   &surface)
  {
    Members members;
    if (!of.empty() && !scope->elements.append_if_known(of, members))
      throw SceneError(place + "'" + of + "' is no element or set of elements of the file");
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
          if (const std::string note = "surface " + surface.name + ": elements of type " +
                                       element.type + " have no face " + label;
              notes.insert(note).second)
            deck.missing.push_back(note);
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



  /// Pressures of *DLOAD (labels P1 to P6) act on faces that often have no name. The faces of each
  /// different value become a surface, so that the scene can refer to them.
  void
  AbaqusReader::read_element_loads()
  {
    ++n_element_loads;
    complete_scope();
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
        add_faces(words[0], "S" + label.substr(1), in.position_in_messages(), loaded[k]);
      }
    whole.surfaces.insert(whole.surfaces.end(), loaded.begin(), loaded.end());
  }



  // Instances, surfaces, element sets and node sets become groups. What has the same name is in the
  // same group.
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
