// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/file_part.h"

#include "mesh_import/cells.h"
#include "mesh_import/division/centers.h"
#include "mesh_import/file_part_steps.h"
#include "mesh_import/pieces.h"
#include <signorini/parameters/raw.h>

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
    /// Throws SceneError for elements that cannot be cells in this dimension.
    template <int dim>
    void
    check_shape(const MeshFile::Element &element)
    {
      if (element.shape == MeshFile::Shape::unknown)
        throw SceneError("has elements of a type that is not known here: " + element.type +
                         ", the first is number " + std::to_string(element.number));
      if (dimension_of(element.shape) > dim)
        throw SceneError("has three-dimensional cells, but Dimension = 2");
      AssertThrow(element.shape == cell_shape<dim> || element.shape == simplex_shape<dim>,
                  ExcInternalError("A cell of a mesh file was not divided."));
    }



    /// @return all elements of dimension `dim`, or those of a part. Throws SceneError if there are
    /// none, or of a wrong kind.
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



    /// @return the elements as cells in deal.II's order of vertices.
    template <int dim>
    std::vector<CellData<dim>>
    cells_of(const std::vector<const MeshFile::Element *> &elements)
    {
      // Files list the corners of a quadrilateral in cyclic order, deal.II in lexicographic order.
      static const std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
      std::vector<CellData<dim>>               cells;
      for (const MeshFile::Element *element : elements)
        {
          const bool is_simplex = element->shape == simplex_shape<dim>;
          cells.emplace_back(n_corners(element->shape));
          for (unsigned int v = 0; v < cells.back().vertices.size(); ++v)
            cells.back().vertices[v] = element->nodes.at(is_simplex ? v : order[v]);
        }
      return cells;
    }



    /// @return the first `dim` coordinates of all nodes.
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



    /// Throws SceneError if the cells of a two-dimensional mesh do not have one z coordinate.
    void
    check_plane(const MeshFile &file, const std::vector<CellData<2>> &cells)
    {
      const double z = file.nodes[cells[0].vertices[0]][2];
      for (const auto &cell : cells)
        for (const unsigned int v : cell.vertices)
          if (std::abs(file.nodes[v][2] - z) > 1e-10 * file.nodes[v].norm())
            throw SceneError("does not lie in the x-y plane, but Dimension = 2");
    }



    /// Throws SceneError if two cells have the same corners, which some programs accept, and then
    /// add their stiffness.
    template <int dim>
    void
    reject_repetitions(const std::vector<CellData<dim>>             &cells,
                       const std::vector<const MeshFile::Element *> &elements,
                       const std::vector<Point<dim>>                &vertices)
    {
      // Cells are sorted by the sum of the squares of their corners, so that few of them have to be
      // compared.
      std::vector<std::pair<std::uint64_t, unsigned int>> all;
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          std::uint64_t sum = 0;
          for (const std::uint64_t node : cells[c].vertices)
            sum += node * node;
          all.emplace_back(sum, c);
        }
      std::sort(all.begin(), all.end());
      std::vector<std::pair<unsigned int, unsigned int>> same;
      for (auto first = all.begin(); first != all.end(); ++first)
        for (auto other = first + 1; other != all.end() && other->first == first->first; ++other)
          if (sorted(cells[first->second].vertices) == sorted(cells[other->second].vertices))
            {
              same.emplace_back(first->second, other->second);
              break;
            }
      if (same.empty())
        return;
      const auto name = [&](const unsigned int c) {
        return "element " + std::to_string(elements[c]->number) + " (" + elements[c]->type + ")";
      };
      const auto &[one, other] = *std::min_element(same.begin(), same.end());
      throw SceneError(
        "has " + name(one) + " twice, also as " + name(other) + ", at " +
        text_of(vertices[sorted(cells[one].vertices)[0]]) +
        (same.size() > 1 ? ", and " + std::to_string(same.size() - 1) + " others" : "") +
        "; remove one of them (CalculiX adds their stiffness: use the sum of the moduli)");
    }



    /// @return the faces that belong to one cell only. Throws SceneError if three cells share a
    /// face.
    template <int dim>
    std::vector<CellData<dim - 1>>
    boundary_faces(const std::vector<CellData<dim>> &cells, const std::vector<Point<dim>> &vertices)
    {
      // Sorted by their nodes, faces of several cells are neighbours.
      struct Face
      {
        Centers::Key key;
        unsigned int cell, face;
      };
      std::vector<Face> all;
      all.reserve(cells.size() * reference_cell_of(cells[0]).n_faces());
      for (unsigned int c = 0; c < cells.size(); ++c)
        for (const unsigned int face : reference_cell_of(cells[c]).face_indices())
          all.push_back({Centers::key(face_nodes(cells[c], face)), c, face});
      std::sort(all.begin(), all.end(), [](const Face &a, const Face &b) { return a.key < b.key; });

      std::vector<std::pair<unsigned int, unsigned int>> at_boundary; // cell, face
      for (auto first = all.begin(), next = first; first != all.end(); first = next)
        {
          next = std::find_if(first, all.end(), [&](const Face &f) { return f.key != first->key; });
          if (next - first > 2)
            throw SceneError("has a face with more than two cells at " +
                             text_of(vertices[first->key[0]]));
          if (next - first == 1)
            at_boundary.emplace_back(first->cell, first->face);
        }
      std::sort(at_boundary.begin(), at_boundary.end());
      std::vector<CellData<dim - 1>> faces;
      for (const auto &[c, face] : at_boundary)
        {
          faces.emplace_back(reference_cell_of(cells[c]).face_reference_cell(face).n_vertices());
          faces.back().vertices = face_nodes(cells[c], face);
        }
      return faces;
    }



    /// The names of all boundaries, and which of them each boundary id has. A face may have several
    /// names, so that ids and names differ.
    struct Names
    {
      std::vector<std::string>               boundaries;
      std::vector<std::vector<unsigned int>> of_ids;

      /// Give some faces a new boundary id.
      /// @param names indices into `boundaries`
      /// @param members indices into `faces`
      /// @param faces the list of all boundary faces
      template <typename Face>
      void
      add(const std::vector<unsigned int> &names,
          const std::vector<unsigned int> &members,
          std::vector<Face>               &faces)
      {
        for (const unsigned int f : members)
          faces[f].boundary_id = of_ids.size();
        of_ids.push_back(names);
      }

      /// @return the index of a name, which is appended if it is new.
      unsigned int
      index(const std::string &name)
      {
        const auto found = std::find(boundaries.begin(), boundaries.end(), name);
        if (found != boundaries.end())
          return found - boundaries.begin();
        boundaries.push_back(name);
        return boundaries.size() - 1;
      }
    };



    /// Give all boundary faces ids, one for all faces that have the same names: first those with
    /// names in the file, in the order of these, then the others, which are called `unnamed`, or
    /// `unnamed1` and so on if a feature angle divides them into patches.
    template <int dim>
    Names
    name_faces(std::vector<CellData<dim - 1>> &faces,
               const std::vector<Point<dim>>  &vertices,
               const FaceNames                &names,
               const double                    feature_angle,
               std::vector<std::string>       &notes)
    {
      std::map<std::set<unsigned int>, std::vector<unsigned int>> named;
      std::set<unsigned int>                                      all;
      for (unsigned int f = 0; f < faces.size(); ++f)
        {
          // Group the faces by their sets of names.
          const std::set<unsigned int> of_face = names(faces[f].vertices);
          named[of_face].push_back(f);
          all.insert(of_face.begin(), of_face.end());
        }
      const std::vector<unsigned int> unnamed = std::move(named[{}]);
      named.erase(std::set<unsigned int>());

      // Faces with names get one boundary id for each set of names.
      Names result;
      for (const unsigned int name : all)
        result.boundaries.push_back(names.name(name));
      for (const auto &[of_faces, members] : named)
        {
          std::vector<unsigned int> indices;
          for (const unsigned int name : of_faces)
            indices.push_back(std::distance(all.begin(), all.find(name)));
          result.add(indices, members, faces);
        }
      if (unnamed.empty())
        return result;
      if (feature_angle == 0)
        {
          result.add({result.index("unnamed")}, unnamed, faces);
          return result;
        }
      // Faces without a name are divided at the feature angle.
      std::vector<CellData<dim - 1>> nameless;
      for (const unsigned int f : unnamed)
        nameless.push_back(faces[f]);
      const auto patches = smooth_patches(nameless, vertices, feature_angle);
      for (unsigned int i = 0; i < patches.size(); ++i)
        {
          std::vector<unsigned int> members;
          for (const unsigned int f : patches[i].faces)
            members.push_back(unnamed[f]);
          const std::string name = "unnamed" + std::to_string(i + 1);
          result.add({result.index(name)}, members, faces);
          notes.push_back("boundary " + name + ": " + std::to_string(members.size()) +
                          " faces about " + text_of(patches[i].center));
        }
      return result;
    }



    /// @return a message about nodes that no element of the file uses, such as reference nodes and
    /// centres of arcs; none if there are no such nodes.
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
      return {std::to_string(n) + " nodes without elements are ignored, the first is at " +
              text_of(file.nodes[first])};
    }



    /// @return a message if the part consists of several pieces that are not connected; none
    /// otherwise.
    std::vector<std::string>
    note_of_pieces(const MeshFile &file, const unsigned int dim, const std::string &part)
    {
      std::vector<bool> wanted(file.elements.size(), part.empty());
      for (const auto &group : file.groups)
        if (group.name == part)
          for (const unsigned int e : group.elements)
            wanted[e] = true;
      const std::vector<Piece> pieces = pieces_of(file, dim, wanted);
      if (pieces.size() < 2)
        return {};
      constexpr unsigned int   most = 20;
      std::vector<std::string> words;
      for (unsigned int i = 0; i < std::min<std::size_t>(pieces.size(), most); ++i)
        words.push_back(description(pieces[i]));
      return {"consists of " + std::to_string(pieces.size()) + " pieces that are not connected: " +
              join(words, "; ") + (pieces.size() > most ? "; ..." : "")};
    }



    /// @return the nodes that cells use, in ascending order.
    template <int dim>
    std::vector<unsigned int>
    nodes_of(const std::vector<CellData<dim>> &cells, const unsigned int n_nodes)
    {
      std::vector<bool> is_used(n_nodes);
      for (const auto &cell : cells)
        for (const unsigned int node : cell.vertices)
          is_used[node] = true;
      std::vector<unsigned int> result;
      for (unsigned int node = 0; node < n_nodes; ++node)
        if (is_used[node])
          result.push_back(node);
      return result;
    }



    /// Replace the vertices of all cells by their representatives.
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



  // See the order of the steps below.
  template <int dim>
  FilePart<dim>::FilePart(const MeshFile &file, const FileSelection &selection)
    : vertices(vertices_of<dim>(file))
    , elements(elements_of<dim>(file, selection.part))
    , notes(file.notes)
  {
    // The order matters: (1) cells from elements; (2) merge coinciding nodes; (3) orientation and
    // checks, which need the final connectivity; (4) names of the boundary faces, which refer to
    // nodes of the file; (5) only then deal.II's consistent numbering of lines, and the removal of
    // unused vertices, which renumber cells and nodes.
    for (const std::string &note : note_of_unused_nodes(file))
      notes.push_back(note);
    if (selection.coinciding_nodes != CoincidingPoints::merge)
      for (const std::string &note : note_of_pieces(file, dim, selection.part))
        notes.push_back(note);
    cells = cells_of<dim>(elements);
    if constexpr (dim == 2)
      check_plane(file, cells);

    std::vector<unsigned int> representatives(vertices.size());
    std::iota(representatives.begin(), representatives.end(), 0);
    if (selection.coinciding_nodes == CoincidingPoints::merge)
      {
        representatives =
          CoincidingNodes<dim>(cells, vertices, selection.node_distance).representatives();
        replace_nodes(cells, representatives);
      }
    orient(cells, vertices, elements);
    if (selection.coinciding_nodes == CoincidingPoints::refuse)
      touching_pieces =
        CoincidingNodes<dim>(cells, vertices, selection.node_distance).reject_cracks();

    file_nodes = nodes_of(cells, vertices.size()); // unused ones are removed below, in this order
    const FaceNames names(file, dim, selection.boundaries, representatives, file_nodes);
    auto           &list = [&]() -> std::vector<CellData<dim - 1>>           &{
      if constexpr (dim == 2)
        return faces.boundary_lines;
      else
        return faces.boundary_quads;
    }();
    reject_repetitions(cells, elements, vertices);
    list = boundary_faces(cells, vertices);
    if (selection.coinciding_nodes != CoincidingPoints::keep)
      reject_hanging_nodes<dim>(cells, list, vertices);
    const Names all_names = name_faces(list, vertices, names, selection.feature_angle, notes);
    boundaries            = all_names.boundaries;
    names_of_ids          = all_names.of_ids;
    std::vector<MeshFile::Nodes> face_corners;
    for (const auto &face : list)
      face_corners.push_back(face.vertices);
    for (const std::string &note : names.notes(face_corners, file_nodes))
      notes.push_back(note);

    for (const unsigned int node : file_nodes)
      inserted.push_back(node >= file.first_inserted);
    if (cells[0].vertices.size() != dim + 1)
      GridTools::consistently_order_cells(cells);
    nodes = FileNodes<dim>(file, cells, elements, representatives);
    GridTools::delete_unused_vertices(vertices, cells, faces);
  }



  template struct FilePart<2>;
  template struct FilePart<3>;
} // namespace Signorini
