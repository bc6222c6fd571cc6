// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/decks/scene_writer.h"
#include "mesh_import/formats/abaqus_elements.h"
#include <signorini/parameters/raw.h>

#include <algorithm>

// Bodies from the connected pieces of the deck's mesh, with their boundaries, materials and
// temperatures.

namespace Signorini
{
  namespace
  {
    using Nodes = MeshFile::Nodes;

    /// @return whether an element has nodes between its corners.
    bool
    is_second_order(const MeshFile::Element &element)
    {
      return element.nodes.size() > n_corners(element.shape);
    }
  } // namespace



  std::string
  SceneWriter::as_name(std::string name)
  {
    for (char &c : name)
      if (std::string("./=;:,#\\").find(c) != std::string::npos)
        c = '_';
    return trim(name).empty() ? "body" : trim(name);
  }



  // Each connected piece becomes a body of its own, because bodies of a scene share no nodes.
  // Pieces without material are skipped.
  void
  SceneWriter::make_bodies()
  {
    const MeshFile          &mesh   = model.deck.mesh;
    const std::vector<Piece> pieces = pieces_of(mesh, dim);
    n_pieces                        = pieces.size();
    for (const Piece &piece : pieces)
      {
        // A unique name, and which nodes and elements of the file belong to the body.
        Body body;
        body.part = piece.name;
        body.name = as_name(piece.name);
        while (std::any_of(all.begin(), all.end(), [&](const Body &other) {
          return other.name == body.name;
        }))
          body.name += "_";
        body.has_node.resize(mesh.nodes.size());
        body.has_element.resize(mesh.elements.size());
        body.is_quadratic = true;
        for (const unsigned int e : piece.elements)
          {
            body.has_element[e] = true;
            body.is_quadratic &= is_second_order(mesh.elements[e]);
            for (const unsigned int node : mesh.elements[e].nodes)
              body.has_node[node] = true;
          }
        body.boundaries = boundaries_of(piece);
        if (!write_material(body, piece))
          continue;
        write_temperature(body);
        if (dim == 2 && !all.empty() && body.thickness != all[0].thickness)
          model.skip_item("different thicknesses of " + all[0].name + " and " + body.name +
                            "; contact acts per thickness",
                          "*SOLID SECTION",
                          "pair");
        all.push_back(body);
      }
    if (all.empty())
      throw SceneError("'" + file + "': no elements have a *SOLID SECTION");
  }



  /// @return the names of the groups that are a boundary of a piece, by the same rule as FaceNames:
  /// groups with one of its boundary faces, and node sets with all corners of one.
  std::set<std::string>
  SceneWriter::boundaries_of(const Piece &piece) const
  {
    const MeshFile &mesh = model.deck.mesh;
    // Faces with one cell are the boundary of the piece.
    std::map<Nodes, unsigned int> n_cells;
    for (const unsigned int e : piece.elements)
      for (const Nodes &face : abaqus_faces(mesh.elements[e], ""))
        ++n_cells[sorted(face)];
    std::set<unsigned int> nodes;
    for (const unsigned int e : piece.elements)
      for (const unsigned int node : corners_of(mesh.elements[e]))
        nodes.insert(node);
    std::set<std::string> result;
    for (const auto &group : mesh.groups)
      {
        bool has_face = false;
        for (const Nodes &face : group.faces)
          if (const auto found = n_cells.find(sorted(face)); found != n_cells.end())
            has_face |= found->second == 1;
        const std::set<unsigned int> set(group.nodes.begin(), group.nodes.end());
        const bool is_all = std::includes(set.begin(), set.end(), nodes.begin(), nodes.end());
        if (!set.empty() && !is_all && group.faces.empty())
          for (const auto &[face, n] : n_cells)
            has_face |=
              n == 1 && std::all_of(face.begin(), face.end(), [&](const unsigned int node) {
                return set.count(node) > 0;
              });
        if (has_face)
          result.insert(group.name);
      }
    return result;
  }



  /// Determine the materials of a body: that of most elements is the material of the body, others
  /// become materials of sets of cells.
  /// @return false if no element has a material, so that the body is skipped
  bool
  SceneWriter::write_material(Body &body, const Piece &piece)
  {
    // Of an element that several sections name, the last one counts.
    std::map<unsigned int, std::string> of_elements;
    std::map<unsigned int, double>      thickness_of;
    for (const auto &one : model.sections)
      for (const unsigned int e : one.elements)
        if (body.has_element[e])
          {
            of_elements[e]  = one.material;
            thickness_of[e] = one.thickness > 0 && kind != "axisymmetric" ? one.thickness : 1;
          }
    if (of_elements.empty())
      {
        model.skip_item(description(piece) + ", which has no *SOLID SECTION", "", "body");
        return false;
      }
    body.thickness = thickness_of.begin()->second;
    if (const auto other =
          std::find_if(thickness_of.begin(),
                       thickness_of.end(),
                       [&](const auto &one) { return one.second != body.thickness; });
        dim == 2 && other != thickness_of.end())
      throw SceneError(
        "'" + file + "': elements " +
        std::to_string(model.deck.mesh.elements[thickness_of.begin()->first].number) + " and " +
        std::to_string(model.deck.mesh.elements[other->first].number) +
        " are connected and have different thicknesses; a plane body has one. Mesh "
        "it in three dimensions");
    // The most frequent material is that of the body.
    std::map<std::string, unsigned int> n;
    for (const auto &element : of_elements)
      ++n[element.second];
    body.material = std::max_element(n.begin(), n.end(), [](const auto &a, const auto &b) {
                      return a.second < b.second;
                    })->first;
    if (of_elements.size() < piece.elements.size())
      model.skip_item("that " + std::to_string(piece.elements.size() - of_elements.size()) +
                        " elements of " + body.name + " have no *SOLID SECTION; they are of " +
                        body.material,
                      "",
                      "body");
    if (n.size() > 1)
      write_other_materials(body);
    for (const auto &[name, count] : n)
      {
        const auto found = model.materials.find(name);
        if (found == model.materials.end() || !found->second.youngs_modulus)
          throw SceneError(
            "'" + file + "': the material '" + name + "' of " + body.name +
            " is not elastic: it has neither *ELASTIC nor one of the *HYPERELASTIC that "
            "are there");
      }
    return true;
  }



  /// List the materials of sets of cells, in the order of the sections, of which later ones have
  /// priority. Sections of the body's own material before the first one of another material are
  /// superfluous.
  void
  SceneWriter::write_other_materials(Body &body)
  {
    for (const auto &section : model.sections)
      {
        if (std::none_of(section.elements.begin(),
                         section.elements.end(),
                         [&](const unsigned int e) { return body.has_element[e]; }))
          continue;
        if (!body.others.empty() || section.material != body.material)
          for (const std::string &set : section.sets)
            body.others.push_back({section.material, set});
      }
  }



  /// Report amplitudes of temperatures that continue over several steps. CalculiX 2.20 restarts
  /// them in each later step at all nodes but one; it does not restart those of loads, and Abaqus
  /// restarts neither.
  void
  SceneWriter::skip_continuing_amplitudes(const DeckModel::Curve &curve)
  {
    for (unsigned int i = 0; i < curve.size(); ++i)
      {
        const unsigned int next = i + 1 < curve.size() ? curve[i + 1].step : model.steps.size() + 1;
        const auto         amplitude = model.amplitudes.find(curve[i].amplitude);
        if (amplitude != model.amplitudes.end() && !amplitude->second.is_total &&
            next > curve[i].step + 1)
          model.skip_item("that CalculiX begins the amplitude of temperatures anew in later steps; "
                          "they stay",
                          "*TEMPERATURE",
                          "load");
      }
  }



  /// Determine the temperature history of a body that expands. The program has one temperature for
  /// each body: if nodes differ, thermal strain is omitted and reported.
  void
  SceneWriter::write_temperature(Body &body)
  {
    bool expands = model.materials.at(body.material).expansion.has_value();
    for (const MaterialOfCells &one : body.others)
      expands |= model.materials.at(one.material).expansion.has_value();
    if (!expands || model.temperatures.empty())
      return;
    // Empty where no node has one; false if they differ.
    using Value     = std::pair<double, std::string>;
    const auto same = [&](const DeckModel::Temperatures &of, std::optional<Value> &value) {
      unsigned int n = 0, n_nodes = 0;
      for (unsigned int node = 0; node < body.has_node.size(); ++node)
        if (body.has_node[node])
          {
            ++n_nodes;
            const auto found = of.of_nodes.find(node);
            if (found == of.of_nodes.end())
              continue;
            if (value && *value != found->second)
              return false;
            value = found->second;
            ++n;
          }
      return n == 0 || n == n_nodes;
    };
    std::optional<Value> initial;
    bool                 is_uniform = same(model.initial_temperatures, initial);
    body.initial_temperature        = initial.value_or(Value()).first;
    DeckModel::Curve curve{{0, body.initial_temperature, "", {}}};
    for (const auto &[step, temperatures] : model.temperatures)
      {
        std::optional<Value> value;
        is_uniform &= same(temperatures, value);
        if (value)
          curve.push_back({step, value->first, value->second, {}});
        else if (temperatures.is_new)
          curve.push_back({step, body.initial_temperature, "", {}});
      }
    if (!is_uniform)
      model.skip_item("temperatures that differ from node to node of " + body.name +
                        "; it has no thermal strain",
                      "*TEMPERATURE",
                      "load");
    else if (curve.size() > 1)
      {
        body.temperature = curve;
        skip_continuing_amplitudes(curve);
      }
  }
} // namespace Signorini
