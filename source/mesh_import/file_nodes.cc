// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/file_nodes.h"

#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"

#include <algorithm>
#include <array>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = MeshFile::Nodes;

    /// @return the edges, faces (3D) and the interior of a cell, each as the numbers of its
    /// vertices.
    std::vector<Nodes>
    objects(const ReferenceCell &cell)
    {
      std::vector<Nodes> result;
      for (unsigned int l = 0; l < cell.n_lines(); ++l)
        {
          const auto ends = ends_of_line(cell, l);
          result.emplace_back(ends.begin(), ends.end());
        }
      Nodes all;
      for (const unsigned int v : cell.vertex_indices())
        all.push_back(v);
      if (cell.get_dimension() == 3)
        for (const unsigned int f : cell.face_indices())
          {
            result.emplace_back();
            for (const unsigned int v : cell.face_reference_cell(f).vertex_indices())
              result.back().push_back(cell.face_to_cell_vertices(f, v, 1));
          }
      result.push_back(all);
      return result;
    }

    /// @return the mean of some vertices of the reference cell.
    template <int dim>
    Point<dim>
    middle_of(const ReferenceCell &cell, const Nodes &vertices)
    {
      Point<dim> result;
      for (const unsigned int v : vertices)
        result += cell.vertex<dim>(v) / double(vertices.size());
      return result;
    }
  } // namespace



  // Vertices of cells, then nodes between the corners of elements that have not been divided, then
  // the sets that contain any of these.
  template <int dim>
  FileNodes<dim>::FileNodes(const MeshFile                               &file,
                            const std::vector<CellData<dim>>             &cells,
                            const std::vector<const MeshFile::Element *> &elements,
                            const std::vector<unsigned int>              &representatives)
  {
    numbers        = file.numbers;
    first_inserted = file.first_inserted;
    n_vertices     = cells[0].vertices.size();
    std::vector<bool> is_known(file.nodes.size());
    for (const auto &cell : cells)
      for (const unsigned int node : cell.vertices)
        {
          vertices.push_back(node);
          is_known[node] = true;
        }
    for (unsigned int c = 0; c < elements.size(); ++c)
      {
        const MeshFile::Element &element = *elements[c];
        const CellShape         &shape   = CellShape::of(element.shape);
        for (unsigned int i = shape.n_corners; i < element.nodes.size(); ++i)
          {
            // Neighbours agree on the vertices around a node, so that its first cell is enough.
            if (is_known[element.nodes[i]])
              continue;
            is_known[element.nodes[i]] = true;
            middles.push_back({element.nodes[i], c, 0});
            for (const unsigned int node : shape.corners_around(i, element))
              {
                const auto &of_cell = cells[c].vertices;
                const auto found = std::find(of_cell.begin(), of_cell.end(), representatives[node]);
                Assert(found != of_cell.end(), ExcInternalError());
                middles.back().vertices |= 1u << (found - of_cell.begin());
              }
          }
      }
    std::sort(middles.begin(), middles.end(), [](const Middle &a, const Middle &b) {
      return a.node < b.node;
    });
    // A set keeps those of its nodes that exist in this mesh.
    for (const auto &group : file.groups)
      {
        std::set<unsigned int> here;
        for (const unsigned int node : group.nodes)
          if (is_known[representatives[node]])
            here.insert(representatives[node]);
        if (!here.empty())
          sets[group.name].assign(here.begin(), here.end());
      }
  }



  /// @return the vertices between which a node lies, sorted.
  template <int dim>
  MeshFile::Nodes
  FileNodes<dim>::vertices_around(const Middle &middle) const
  {
    Nodes result;
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (middle.vertices & (1u << v))
        result.push_back(vertices[middle.cell * n_vertices + v]);
    return sorted(result);
  }



  /// @return a node in the middle of vertices; none if it is a vertex.
  template <int dim>
  const typename FileNodes<dim>::Middle *
  FileNodes<dim>::middle_at(const unsigned int node) const
  {
    const auto found = std::lower_bound(middles.begin(),
                                        middles.end(),
                                        node,
                                        [](const Middle &middle, const unsigned int wanted) {
                                          return middle.node < wanted;
                                        });
    return found != middles.end() && found->node == node ? &*found : nullptr;
  }



  template <int dim>
  std::vector<std::string>
  FileNodes<dim>::names() const
  {
    std::vector<std::string> result;
    for (const auto &[name, nodes] : sets)
      result.push_back(name);
    return result;
  }



  // The name of a set has priority over a number. INSTANCE.NUMBER is a node of an instance of an
  // assembly.
  template <int dim>
  MeshFile::Nodes
  FileNodes<dim>::nodes_called(const std::string &name) const
  {
    if (const auto set = sets.find(name); set != sets.end())
      return set->second;
    const auto  dot      = name.rfind('.');
    std::string instance = dot == std::string::npos ? "" : name.substr(0, dot);
    std::transform(instance.begin(), instance.end(), instance.begin(), ::toupper);
    const std::string      number      = dot == std::string::npos ? name : name.substr(dot + 1);
    const auto             of          = numbers.find(instance);
    constexpr unsigned int most_digits = 18;
    if (of == numbers.end() || number.empty() || number.size() > most_digits ||
        number.find_first_not_of("0123456789") != std::string::npos)
      return {};
    const auto node = of->second.find(std::stoul(number));
    return node == of->second.end() ? Nodes() : Nodes{node->second};
  }



  // Nodes of a set are found on all cells that have them: at vertices, and as middles of edges,
  // faces and cells, which are identified by the sorted corners around them. Only cells with at
  // least two corners near such a middle are searched for middles.
  template <int dim>
  NodeSet<dim>
  FileNodes<dim>::find(const std::string &name) const
  {
    // Sort the nodes of the set by whether they are corners or middles.
    const Nodes                          nodes = nodes_called(name);
    std::map<unsigned int, unsigned int> at_corner; // index into the set
    std::map<Nodes, unsigned int>        at_middle;
    std::set<unsigned int>               near_middle;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (const Middle *middle = middle_at(nodes[i]))
        {
          const Nodes around = vertices_around(*middle);
          at_middle[around]  = i;
          near_middle.insert(around.begin(), around.end());
        }
      else
        at_corner[nodes[i]] = i;

    NodeSet<dim> result;
    if (nodes.empty() || vertices.empty())
      return result;
    // Middles that are not in the set, although all corners around them are.
    std::set<Nodes> left_out;
    for (const Middle &middle : middles)
      if (const Nodes around = vertices_around(middle);
          at_middle.count(around) == 0 &&
          std::all_of(around.begin(), around.end(), [&](const unsigned int node) {
            return at_corner.count(node) > 0;
          }))
        {
          left_out.insert(around);
          near_middle.insert(around.begin(), around.end());
        }
    result.nodes.resize(nodes.size());
    const ReferenceCell      reference       = ReferenceCell::n_vertices_to_type(dim, n_vertices);
    const std::vector<Nodes> edges_and_faces = objects(reference);
    for (unsigned int c = 0; c < vertices.size() / n_vertices; ++c)
      {
        const unsigned int *const corners = &vertices[c * n_vertices];
        for (unsigned int v = 0; v < n_vertices; ++v)
          if (const auto found = at_corner.find(corners[v]); found != at_corner.end())
            result.nodes[found->second].push_back(
              {c, reference.vertex<dim>(v), corners[v] >= first_inserted});
        // A cell is searched for middles only if at least two of its corners surround one.
        const auto n_near =
          std::count_if(corners, corners + n_vertices, [&](const unsigned int node) {
            return near_middle.count(node) > 0;
          });
        if (n_near > 1)
          for (const Nodes &object : edges_and_faces)
            {
              Nodes of_object;
              for (const unsigned int v : object)
                of_object.push_back(corners[v]);
              std::sort(of_object.begin(), of_object.end());
              const NodeLocation<dim> place{c, middle_of<dim>(reference, object)};
              if (const auto found = at_middle.find(of_object); found != at_middle.end())
                result.nodes[found->second].push_back(place);
              else if (left_out.count(of_object) > 0)
                result.left_out.push_back(place);
            }
      }
    result.nodes.erase(std::remove_if(result.nodes.begin(),
                                      result.nodes.end(),
                                      [](const auto &places) { return places.empty(); }),
                       result.nodes.end());
    return result;
  }



  template class FileNodes<2>;
  template class FileNodes<3>;
} // namespace Signorini
