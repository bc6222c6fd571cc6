#include <signorini/mesh/generators/cell_checks.h>
#include <signorini/mesh/generators/cells.h>
#include <signorini/mesh/generators/coinciding_nodes.h>
#include <signorini/mesh/generators/face_names.h>
#include <signorini/mesh/generators/file_part.h>
#include <signorini/mesh/generators/smooth_patches.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    constexpr MeshFile::Shape cell_shape =
      dim == 2 ? MeshFile::Shape::quadrilateral : MeshFile::Shape::hexahedron;



    template <int dim>
    void
    check_shape(const MeshFile::Element &element)
    {
      if (element.shape == MeshFile::Shape::unknown)
        throw SceneError("has elements of a type that is not known here: " + element.type +
                         ", the first is number " + std::to_string(element.number));
      if (dimension_of(element.shape) > dim)
        throw SceneError("has cells in three dimensions, the scene has two");
      if (element.shape != cell_shape<dim>)
        throw SceneError(
          std::string("has cells that are not ") + (dim == 2 ? "quadrilaterals" : "hexahedra") +
          ", the first is element " + std::to_string(element.number) + " of type " + element.type +
          "; make all of them so in Gmsh: " + (dim == 2 ? "Recombine Surface \"*\"; or " : "") +
          "Mesh.SubdivisionAlgorithm = " + (dim == 2 ? "1" : "2") +
          "; RefineMesh; as meshes/README.md explains");
    }



    /// All cells of the dimension, or those of the part.
    template <int dim>
    std::vector<const MeshFile::Element *>
    elements_of(const MeshFile &file, const std::string &part)
    {
      std::vector<bool> wanted(file.elements.size(), part.empty());
      for (const auto &group : file.groups)
        if (!part.empty() && group.name == part)
          for (const unsigned int e : group.elements)
            wanted[e] = true;

      std::vector<const MeshFile::Element *> elements;
      for (unsigned int e = 0; e < wanted.size(); ++e)
        if (wanted[e] && dimension_of(file.elements[e].shape) >= dim)
          {
            check_shape<dim>(file.elements[e]);
            elements.push_back(&file.elements[e]);
          }
      if (elements.empty())
        throw SceneError(part.empty() ? "has no cells of dimension " + std::to_string(dim) :
                                        "has no cells in the part '" + part + "'");
      return elements;
    }



    template <int dim>
    std::vector<CellData<dim>>
    cells_of(const std::vector<const MeshFile::Element *> &elements)
    {
      // Files go around the quadrilateral, deal.II crosses over.
      static const std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
      std::vector<CellData<dim>>               cells(elements.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
          cells[c].vertices[v] = elements[c]->nodes.at(order[v]);
      return cells;
    }



    template <int dim>
    std::vector<Point<dim>>
    vertices_of(const MeshFile &file)
    {
      std::vector<Point<dim>> vertices(file.nodes.size());
      for (unsigned int i = 0; i < vertices.size(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          vertices[i][d] = file.nodes[i][d];
      return vertices;
    }



    void
    check_plane(const MeshFile &file, const std::vector<CellData<2>> &cells)
    {
      const double z = file.nodes[cells[0].vertices[0]][2];
      for (const auto &cell : cells)
        for (const unsigned int v : cell.vertices)
          if (std::abs(file.nodes[v][2] - z) > 1e-10 * file.nodes[v].norm())
            throw SceneError("does not lie in the plane of x and y, the scene is two-dimensional");
    }



    /// Faces with one cell. Two cells share an inner face.
    template <int dim>
    std::vector<CellData<dim - 1>>
    boundary_faces(const std::vector<CellData<dim>> &cells, const std::vector<Point<dim>> &vertices)
    {
      std::map<MeshFile::Nodes, unsigned int> n_cells;
      for (const auto &cell : cells)
        for (const unsigned int face : GeometryInfo<dim>::face_indices())
          ++n_cells[sorted(face_nodes(cell, face))];

      std::vector<CellData<dim - 1>> faces;
      for (const auto &cell : cells)
        for (const unsigned int face : GeometryInfo<dim>::face_indices())
          {
            const MeshFile::Nodes nodes = face_nodes(cell, face);
            const unsigned int    n     = n_cells[sorted(nodes)];
            if (n > 2)
              throw SceneError("has a face with more than two cells at " +
                               text_of(vertices[nodes[0]]) + "; is a cell there twice?");
            if (n == 1)
              {
                faces.emplace_back();
                faces.back().vertices = nodes;
              }
          }
      return faces;
    }



    /// Give the faces boundary ids, and say what these are called: first the names in the file,
    /// then those of the faces that have none.
    template <int dim>
    std::vector<std::string>
    name_faces(std::vector<CellData<dim - 1>> &faces,
               const std::vector<Point<dim>>  &vertices,
               const FaceNames                &names,
               const double                    feature_angle,
               std::vector<std::string>       &notes)
    {
      std::map<unsigned int, std::vector<unsigned int>> named;
      for (unsigned int f = 0; f < faces.size(); ++f)
        named[names(faces[f].vertices)].push_back(f);
      std::vector<unsigned int> unnamed = std::move(named[FaceNames::none]);
      named.erase(FaceNames::none);

      std::vector<std::string> boundaries;
      const auto add = [&](const std::string &name, const std::vector<unsigned int> &members) {
        for (const unsigned int f : members)
          faces[f].boundary_id = boundaries.size();
        boundaries.push_back(name);
      };
      for (const auto &[name, members] : named)
        add(names.name(name), members);
      if (unnamed.empty())
        return boundaries;
      if (feature_angle == 0)
        {
          add("unnamed", unnamed);
          return boundaries;
        }
      std::vector<CellData<dim - 1>> nameless;
      for (const unsigned int f : unnamed)
        nameless.push_back(faces[f]);
      const auto patches = smooth_patches(nameless, vertices, feature_angle);
      for (unsigned int i = 0; i < patches.size(); ++i)
        {
          std::vector<unsigned int> members;
          for (const unsigned int f : patches[i].faces)
            members.push_back(unnamed[f]);
          add("unnamed" + std::to_string(i + 1), members);
          notes.push_back("boundary " + boundaries.back() + ": " + std::to_string(members.size()) +
                          " faces about " + text_of(patches[i].center));
        }
      return boundaries;
    }



    /// Nodes that no element of the file uses: forgotten ones, and those of references and arcs.
    std::vector<std::string>
    note_of_unused_nodes(const MeshFile &file)
    {
      std::vector<bool> used(file.nodes.size());
      for (const auto &element : file.elements)
        for (const unsigned int node : element.nodes)
          used[node] = true;
      const auto n = std::count(used.begin(), used.end(), false);
      if (n == 0)
        return {};
      const auto first = std::find(used.begin(), used.end(), false) - used.begin();
      return {std::to_string(n) + " nodes that no element uses are left out, the first is at " +
              text_of(file.nodes[first])};
    }



    template <int dim>
    void
    replace_nodes(std::vector<CellData<dim>>      &cells,
                  const std::vector<unsigned int> &representatives)
    {
      for (auto &cell : cells)
        for (unsigned int &node : cell.vertices)
          node = representatives[node];
    }
  } // namespace



  template <int dim>
  FilePart<dim>::FilePart(const MeshFile &file, const FileSelection &selection)
    : vertices(vertices_of<dim>(file))
    , elements(elements_of<dim>(file, selection.part))
    , notes(note_of_unused_nodes(file))
  {
    cells = cells_of<dim>(elements);
    if constexpr (dim == 2)
      check_plane(file, cells);

    std::vector<unsigned int> representatives(vertices.size());
    std::iota(representatives.begin(), representatives.end(), 0);
    if (selection.coinciding_nodes == "merge")
      {
        representatives =
          CoincidingNodes<dim>(cells, vertices, selection.node_distance).representatives();
        replace_nodes(cells, representatives);
      }
    orient(cells, vertices, elements);
    if (selection.coinciding_nodes == "refuse")
      CoincidingNodes<dim>(cells, vertices, selection.node_distance).refuse();

    std::set<unsigned int> nodes;
    for (const auto &cell : cells)
      nodes.insert(cell.vertices.begin(), cell.vertices.end());
    const FaceNames names(file, dim, selection.boundaries, representatives, nodes);
    auto           &list = [&]() -> std::vector<CellData<dim - 1>>           &{
      if constexpr (dim == 2)
        return faces.boundary_lines;
      else
        return faces.boundary_quads;
    }();
    list       = boundary_faces(cells, vertices);
    boundaries = name_faces(list, vertices, names, selection.feature_angle, notes);

    GridTools::delete_unused_vertices(vertices, cells, faces);
    GridTools::consistently_order_cells(cells);
  }



  template struct FilePart<2>;
  template struct FilePart<3>;
} // namespace Signorini
