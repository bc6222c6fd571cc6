#include <signorini/mesh/generators/gmsh_part.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = std::vector<unsigned int>;

    Nodes
    sorted(Nodes nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }



    template <int dim>
    std::string
    text(const Point<dim> &p)
    {
      std::ostringstream out;
      out << '(' << p << ')';
      return out.str();
    }



    template <int dim>
    void
    check_type(const GmshFile::Element &element)
    {
      if (element.dimension > dim)
        throw SceneError(dim == 2 ? "has cells in three dimensions, the scene has two" :
                                    "has elements of a type that is not known here: " +
                                      std::to_string(element.type));
      if (element.dimension != dim || element.type == (dim == 2 ? 3 : 5))
        return;
      if (element.type == (dim == 2 ? 10 : 12) || element.type == (dim == 2 ? 16 : 17))
        throw SceneError(
          "has cells of second order; save it with Mesh.ElementOrder = 1 and say which "
          "boundaries are curved by the key 'Curved boundaries'");
      throw SceneError(dim == 2 ?
                         "has cells that are not quadrilaterals; make all of them so: "
                         "Recombine Surface \"*\"; Mesh.SubdivisionAlgorithm = 1;" :
                         "has cells that are not hexahedra; make all of them so: transfinite or "
                         "extruded volumes with Recombine, or Mesh.SubdivisionAlgorithm = 2;");
    }



    template <int dim>
    Nodes
    face_nodes(const CellData<dim> &cell, const unsigned int face)
    {
      Nodes nodes(GeometryInfo<dim>::vertices_per_face);
      for (unsigned int v = 0; v < nodes.size(); ++v)
        nodes[v] = cell.vertices[GeometryInfo<dim>::face_to_cell_vertices(face, v)];
      return nodes;
    }



    /// Physical tags of the part's cells; cells without a tag count as 0.
    template <int dim>
    bool
    belongs(const GmshFile::Element &element, const GmshFile &file, const std::string &part)
    {
      if (element.dimension != dim)
        return false;
      const auto group = file.groups[dim].find(element.group);
      return part.empty() || (group != file.groups[dim].end() && group->second == part);
    }



    template <int dim>
    std::vector<CellData<dim>>
    cells_of(const GmshFile &file, const std::string &part)
    {
      std::vector<CellData<dim>> cells;
      for (const auto &element : file.elements)
        if (belongs<dim>(element, file, part))
          {
            check_type<dim>(element);
            cells.emplace_back();
            // Gmsh goes around the quadrilateral, deal.II crosses over.
            static const std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
            for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
              cells.back().vertices[v] = element.nodes.at(order[v]);
          }
        else if (element.dimension > dim)
          check_type<dim>(element);
      if (cells.empty())
        throw SceneError(part.empty() ? "has no cells of dimension " + std::to_string(dim) :
                                        "has no cells in the part '" + part + "'");
      return cells;
    }



    /// Boundary id of each face that the file names.
    template <int dim>
    std::map<Nodes, types::boundary_id>
    named_faces(const GmshFile &file, const std::vector<std::string> &names)
    {
      std::map<Nodes, types::boundary_id> result;
      for (const auto &element : file.elements)
        {
          const auto group = file.groups[dim - 1].find(element.group);
          if (element.dimension != dim - 1 || group == file.groups[dim - 1].end())
            continue;
          const auto               name = std::find(names.begin(), names.end(), group->second);
          const types::boundary_id id   = name - names.begin();
          const auto [entry, is_new]    = result.insert({sorted(element.nodes), id});
          if (!is_new && entry->second != id)
            throw SceneError("has a face that is both in '" + names.at(entry->second) +
                             "' and in '" + names.at(id) + "'; leave it in one");
        }
      return result;
    }



    template <int dim>
    std::vector<CellData<dim - 1>>
    boundary_faces(const std::vector<CellData<dim>>          &cells,
                   const std::map<Nodes, types::boundary_id> &named,
                   const types::boundary_id                   unnamed)
    {
      std::map<Nodes, unsigned int> n_cells;
      for (const auto &cell : cells)
        for (const unsigned int face : GeometryInfo<dim>::face_indices())
          ++n_cells[sorted(face_nodes(cell, face))];

      std::vector<CellData<dim - 1>> faces;
      for (const auto &cell : cells)
        for (const unsigned int face : GeometryInfo<dim>::face_indices())
          {
            const Nodes        nodes = face_nodes(cell, face), key = sorted(nodes);
            const unsigned int n = n_cells[key];
            if (n > 2)
              throw SceneError("has a face with more than two cells; is a cell there twice?");
            if (n == 1)
              {
                const auto entry = named.find(key);
                faces.emplace_back();
                faces.back().vertices    = nodes;
                faces.back().boundary_id = entry == named.end() ? unnamed : entry->second;
              }
          }
      return faces;
    }



    template <int dim>
    std::vector<Point<dim>>
    vertices_of(const GmshFile &file)
    {
      std::vector<Point<dim>> vertices(file.nodes.size());
      for (unsigned int i = 0; i < vertices.size(); ++i)
        {
          for (unsigned int d = 0; d < dim; ++d)
            vertices[i][d] = file.nodes[i][d];
          if (dim == 2 &&
              std::abs(file.nodes[i][2] - file.nodes[0][2]) > 1e-10 * file.nodes[i].norm())
            throw SceneError("does not lie in the plane of x and y, the scene is two-dimensional");
        }
      return vertices;
    }



    template <int dim>
    void
    check_volumes(const std::vector<Point<dim>> &vertices, const std::vector<CellData<dim>> &cells)
    {
      for (const auto &cell : cells)
        {
          Point<dim>     corners[GeometryInfo<dim>::vertices_per_cell];
          Tensor<0, dim> volumes[GeometryInfo<dim>::vertices_per_cell];
          for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
            corners[v] = vertices[cell.vertices[v]];
          GeometryInfo<dim>::alternating_form_at_vertices(corners, volumes);
          for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
            if (!(volumes[v] > 0))
              throw SceneError("has a cell that is folded at its corner " + text(corners[v]) +
                               "; improve the mesh there");
        }
    }



    /// Cells of one part that touch without sharing nodes would come apart.
    template <int dim>
    void
    check_connection(const std::vector<Point<dim>> &vertices)
    {
      double size = 0;
      for (const Point<dim> &p : vertices)
        size = std::max(size, p.distance(vertices[0]));
      std::set<std::array<long, dim>> places;
      for (const Point<dim> &p : vertices)
        {
          std::array<long, dim> place;
          for (unsigned int d = 0; d < dim; ++d)
            place[d] = std::lround((p[d] - vertices[0][d]) / (1e-8 * size));
          if (!places.insert(place).second)
            throw SceneError(
              "has two nodes of the part at " + text(p) +
              ", so that cells are not connected there; merge them in Gmsh (Coherence "
              "Mesh;), or give each side a physical name of its own");
        }
    }
  } // namespace



  template <int dim>
  GmshPart<dim>::GmshPart(const GmshFile                 &file,
                          const std::string              &part,
                          const std::vector<std::string> &names,
                          const types::boundary_id        unnamed)
    : cells(cells_of<dim>(file, part))
    , vertices(vertices_of<dim>(file))
  {
    const auto named = boundary_faces<dim>(cells, named_faces<dim>(file, names), unnamed);
    if constexpr (dim == 2)
      faces.boundary_lines = named;
    else
      faces.boundary_quads = named;

    GridTools::delete_unused_vertices(vertices, cells, faces);
    GridTools::invert_cells_with_negative_measure(vertices, cells);
    GridTools::consistently_order_cells(cells);
    check_volumes(vertices, cells);
    if (!part.empty())
      check_connection(vertices);
  }



  template struct GmshPart<2>;
  template struct GmshPart<3>;
} // namespace Signorini
