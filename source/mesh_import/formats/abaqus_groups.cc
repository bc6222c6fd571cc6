// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_reader.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

// The part of the reader for sets and surfaces, which become the groups of the mesh.

namespace Signorini
{
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
    complete_elements();
    complete_sets();
    for (const LateSurface &late : scope->late_surfaces)
      scope->surfaces.push_back(completed(late));
    scope->late_surfaces.clear();
  }



  /// Elements such as those of distributing couplings may have nodes that are defined below them.
  /// Nodes that do not exist are left out, and those that still may come are tried again.
  void
  AbaqusReader::complete_elements()
  {
    for (const LateElement &late : scope->late_elements)
      {
        MeshFile::Nodes members;
        for (const std::size_t number : late.nodes)
          if (const unsigned int node = scope->nodes.index(number); node != AbaqusSets::none)
            members.push_back(node);
        scope->mesh->elements[late.index].nodes = reordered(late.type, members);
      }
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
  // The place of each data line was stored with it, since the file has been read to the end of the
  // scope when the lines are interpreted.
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
  // Sizes are added as floating-point numbers before the check, so that a sum beyond the range of
  // integers is noticed. A union may name a surface that is itself a union, so that sizes can
  // double from line to line.
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
    // A set may contain the same elements many times: the check protects the memory from small
    // files that describe huge surfaces.
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
  /// Loads refer to elements that are complete at this place of the file, so that the references of
  /// the scope are resolved first. DeckReader::read_element_loads() makes the same names in the
  /// same order.
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
  // Sets are stored by names in upper case; groups have the names as they are written in the file.
  void
  AbaqusReader::make_groups()
  {
    MeshFile &file = *whole.mesh;
    for (const MeshFile::Group &one : instances)
      {
        // An element set may have the name of an instance only if both have the same elements,
        // since a scene could not distinguish them.
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
} // namespace Signorini
