#include <signorini/import/scene_writer.h>
#include <signorini/mesh/formats/abaqus_elements.h>
#include <signorini/mesh/generators/cells.h>
#include <signorini/parameters/raw.h>

#include <algorithm>

// The pieces of the deck's mesh as bodies, with their boundaries, materials and temperatures.

namespace Signorini
{
  namespace
  {
    using Nodes = MeshFile::Nodes;

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



  void
  SceneWriter::make_bodies()
  {
    const MeshFile &mesh = model.deck.mesh;
    for (const Piece &piece : pieces_of(mesh, dim))
      {
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
        give_material(body, piece);
        give_temperature(body);
        if (dim == 2 && !all.empty() && body.thickness != all[0].thickness)
          model.leave_out("different thicknesses of " + all[0].name + " and " + body.name +
                            "; contact acts per thickness",
                          "*SOLID SECTION");
        all.push_back(body);
      }
  }



  /// The names that have a face of the piece, as the mesh file's faces get them: by an element, or
  /// by all of their corners.
  std::set<std::string>
  SceneWriter::boundaries_of(const Piece &piece) const
  {
    const MeshFile               &mesh = model.deck.mesh;
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



  /// The material of most elements; a body has one.
  void
  SceneWriter::give_material(Body &body, const Piece &piece)
  {
    std::map<std::string, unsigned int> n;
    for (const auto &one : model.sections)
      for (const unsigned int e : one.elements)
        if (body.has_element[e])
          {
            ++n[one.material];
            if (one.thickness > 0 && kind != "axisymmetric")
              body.thickness = one.thickness;
          }
    if (n.empty())
      throw SceneError("'" + file + "': the elements of " + description(piece) +
                       " have no *SOLID SECTION");
    const auto most = std::max_element(n.begin(), n.end(), [](const auto &a, const auto &b) {
      return a.second < b.second;
    });
    body.material   = most->first;
    for (const auto &[material, count] : n)
      if (material != body.material)
        model.leave_out("material " + material + " of " + std::to_string(count) + " elements of " +
                          body.name +
                          " (a connected body has one material, that of the most "
                          "elements: " +
                          body.material + ")",
                        "*SOLID SECTION");
    const auto found = model.materials.find(body.material);
    if (found == model.materials.end() || !found->second.youngs_modulus)
      throw SceneError("'" + file + "': the material '" + body.material + "' of " + body.name +
                       " is not linear elastic: *ELASTIC is missing");
  }



  /// A body has one temperature, from its initial one on.
  void
  SceneWriter::give_temperature(Body &body)
  {
    if (!model.materials.at(body.material).expansion || model.temperatures.empty())
      return;
    // Empty where no node has one; false if they differ.
    const auto same = [&](const std::map<unsigned int, double> &of_nodes,
                          std::optional<double>                &value) {
      unsigned int n = 0, n_nodes = 0;
      for (unsigned int node = 0; node < body.has_node.size(); ++node)
        if (body.has_node[node])
          {
            ++n_nodes;
            const auto found = of_nodes.find(node);
            if (found == of_nodes.end())
              continue;
            if (value && *value != found->second)
              return false;
            value = found->second;
            ++n;
          }
      return n == 0 || n == n_nodes;
    };
    std::optional<double> initial;
    bool                  is_uniform = same(model.initial_temperatures, initial);
    body.initial_temperature         = initial.value_or(0);
    DeckModel::Curve curve{{0, body.initial_temperature, "", {}}};
    for (const auto &[step, temperatures] : model.temperatures)
      {
        std::optional<double> value;
        is_uniform &= same(temperatures.of_nodes, value);
        if (value)
          curve.push_back({step, *value, temperatures.amplitude, {}});
      }
    if (!is_uniform)
      model.leave_out("temperatures that differ from node to node of " + body.name +
                        "; it has no thermal strain",
                      "*TEMPERATURE");
    else if (curve.size() > 1)
      body.temperature = curve;
  }
} // namespace Signorini
