// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/division/centers.h"
#include "mesh_import/division/chosen_cells.h"
#include "mesh_import/division/subdivisions.h"
#include "mesh_import/import_steps.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <map>
#include <unordered_map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Shape = MeshFile::Shape;
    using Nodes = MeshFile::Nodes;

    /// Midpoint subdivision of the chosen elements of a file, see divide_cells(), or only their
    /// division into simplices, see cut_into_simplices(). Cost: linear in the number of elements,
    /// by hash tables of edges and faces.
    class HexSubdivision
    {
    public:
      HexSubdivision(MeshFile          &file,
                     const unsigned int dim,
                     const ChosenCells &chosen,
                     const bool         to_simplices)
        : file(file)
        , dim(dim)
        , chosen(chosen)
        , to_simplices(to_simplices)
        , centers(file)
        , report(file, dim)
      {}

      /// Divide all chosen elements.
      /// @return what the user is told: the summary, and the worst shapes
      std::vector<std::string>
      divide(const bool mid_side_nodes)
      {
        // The nodes of second order are registered first, so that neighbours without them use the
        // same ones. Pyramids and cells connected with them are replaced by tetrahedra. Only then
        // the boundary is known, as the faces that occur once, and the cells are divided.
        check_conforming();
        for (unsigned int e = 0; e < file.elements.size(); ++e)
          if (chosen.all[e])
            {
              if (!mid_side_nodes)
                straighten(file.elements[e]);
              centers.take(file.elements[e]);
            }
        // A pyramid has a corner with four faces, for which midpoint subdivision gives no
        // hexahedron.
        cut_pyramids();
        count_faces();
        std::vector<std::string> notes = {division_summary()};
        for (const std::string &note : divide_elements())
          notes.push_back(note);
        centers.complete_node_sets();
        centers.complete_fields();
        return notes;
      }

    private:
      /// Throws SceneError if a cell occurs twice, or if a quadrilateral face at the boundary lies
      /// on two triangles of other cells: neighbours would not be connected after the division.
      void
      check_conforming()
      {
        // Count cells by their corners and faces by theirs.
        std::map<MeshFile::Nodes, unsigned int>                       cells_of;
        std::unordered_map<Centers::Key, unsigned int, Centers::Hash> n_faces;
        const auto name = [&](const unsigned int e) {
          return "element " + std::to_string(file.elements[e].number) + " (" +
                 file.elements[e].type + ")";
        };
        for (unsigned int e = 0; e < file.elements.size(); ++e)
          if (chosen.all[e])
            {
              const auto [found, is_new] =
                cells_of.insert({sorted(corners_of(file.elements[e])), e});
              if (!is_new)
                throw SceneError("has " + name(e) + " twice, also as " + name(found->second) +
                                 ", at " + text_of(file.nodes[file.elements[e].nodes[0]]));
              for (const Nodes &face : CellShape::of(file.elements[e].shape).faces)
                ++n_faces[Centers::key(nodes_at(file.elements[e], face))];
            }
        for (unsigned int e = 0; dim == 3 && e < file.elements.size(); ++e)
          if (chosen.all[e])
            for (const Nodes &face : CellShape::of(file.elements[e].shape).faces)
              {
                // A quadrilateral without neighbour must not contain a triangle of another cell.
                const Nodes around = nodes_at(file.elements[e], face);
                if (around.size() != 4 || n_faces[Centers::key(around)] != 1)
                  continue;
                // The four triples of consecutive corners are all triangles into which either
                // diagonal divides the quadrilateral.
                for (unsigned int i = 0; i < 4; ++i)
                  if (n_faces.count(
                        Centers::key({around[i], around[(i + 1) % 4], around[(i + 2) % 4]})) > 0)
                    throw SceneError(
                      "has a quadrilateral face of " + name(e) + " at " +
                      text_of(file.nodes[around[i]]) +
                      " where the cells beside it have triangles, so that they are not connected; "
                      "insert pyramids, or use two bodies with a contact pair");
              }
      }

      /// Move the nodes of second order of an element to the mean of the corners around them.
      void
      straighten(const MeshFile::Element &element)
      {
        const CellShape &shape = CellShape::of(element.shape);
        for (unsigned int i = shape.n_corners; i < element.nodes.size(); ++i)
          {
            const Nodes around = shape.corners_around(i, element);
            Point<3>    sum;
            for (const unsigned int corner : around)
              sum += file.nodes[corner];
            file.nodes[element.nodes[i]] = sum / double(around.size());
          }
      }

      /// Fill `cells` with the cells that midpoint subdivision divides: the chosen elements
      /// themselves, or the tetrahedra into which they are cut. `first_cell` has the index of the
      /// first cell of each element.
      void
      cut_pyramids()
      {
        for (unsigned int e = 0; e < file.elements.size(); ++e)
          {
            first_cell.push_back(cells.size());
            if (chosen.as_simplices[e])
              {
                for (const Nodes &face : CellShape::of(file.elements[e].shape).faces)
                  if (face.size() == 4)
                    store_triangles(nodes_at(file.elements[e], face));
                for (const auto &cell : simplices_of(file.elements[e], file, centers))
                  cells.push_back(cell);
              }
            else if (chosen.all[e])
              cells.push_back(file.elements[e]);
          }
        first_cell.push_back(cells.size());
      }

      /// Record of which quadrilateral of the file the two triangles of a cut face are parts.
      void
      store_triangles(const Nodes &around)
      {
        for (const Nodes &triangle : triangles_of(around))
          whole[Centers::key(triangle)] = around;
      }

      /// Count the cells at each face, to find those at the boundary.
      void
      count_faces()
      {
        for (const MeshFile::Element &cell : cells)
          for (const Nodes &face : CellShape::of(cell.shape).faces)
            ++n_cells[Centers::key(nodes_at(cell, face))];
      }

      /// @return one line for the user: what was divided into how many cells.
      std::string
      division_summary() const
      {
        static const std::vector<std::pair<Shape, std::string>> names = {
          {Shape::triangle, "triangle"},
          {Shape::quadrilateral, "quadrilateral"},
          {Shape::tetrahedron, "tetrahedron"},
          {Shape::pyramid, "pyramid"},
          {Shape::wedge, "wedge"},
          {Shape::hexahedron, "hexahedron"}};
        std::vector<std::string> counts;
        unsigned int             n_cut = 0, n_pyramids = 0, n_children = 0;
        // Elements of each shape; those other than pyramids that become tetrahedra are counted
        // separately.
        for (const auto &[shape, name] : names)
          {
            unsigned int n = 0;
            for (unsigned int e = 0; e < file.elements.size(); ++e)
              if (chosen.all[e] && file.elements[e].shape == shape)
                {
                  ++n;
                  n_cut += chosen.as_simplices[e] && shape != Shape::pyramid;
                }
            if (shape == Shape::pyramid)
              n_pyramids = n;
            if (n > 0)
              counts.push_back(counted(n, name));
          }
        if (to_simplices)
          return join(counts) + " cut into " + std::to_string(cells.size()) +
                 (dim == 2 ? " triangles" : " tetrahedra");
        // Each cell has as many children as corners.
        for (const MeshFile::Element &cell : cells)
          n_children += n_corners(cell.shape);
        std::string text = join(counts) + " divided into " + std::to_string(n_children) +
                           (dim == 2 ? " quadrilaterals" : " hexahedra");
        if (n_pyramids > 0)
          text += "; pyramids cannot be subdivided into hexahedra conformingly: they" +
                  (n_cut > 0 ? " and " + std::to_string(n_cut) +
                                 " cells connected with them by quadrilaterals" :
                               "") +
                  " are divided into tetrahedra first; a mesh without pyramids needs fewer cells";
        return text;
      }

      /// @return a number with the plural of a shape's name where needed: "tetrahedra", "wedges".
      static std::string
      counted(const unsigned int n, const std::string &name)
      {
        const bool greek = name.size() > 5 && name.substr(name.size() - 5) == "edron";
        return std::to_string(n) + " " +
               (n == 1 ? name :
                greek  ? name.substr(0, name.size() - 2) + "a" :
                         name + "s");
      }

      /// Replace the elements by their children, also in the groups.
      /// @return messages about the shapes of the children
      std::vector<std::string>
      divide_elements()
      {
        std::vector<MeshFile::Element> elements;
        std::vector<unsigned int>      first;
        for (unsigned int e = 0; e < file.elements.size(); ++e)
          {
            first.push_back(elements.size());
            if (!chosen.all[e])
              elements.push_back(file.elements[e]);
            for (unsigned int c = first_cell[e]; c < first_cell[e + 1]; ++c)
              if (to_simplices)
                keep(cells[c], file.elements[e], elements);
              else
                divide(cells[c], file.elements[e], elements);
          }
        first.push_back(elements.size());
        for (MeshFile::Group &group : file.groups)
          {
            std::vector<unsigned int> members;
            for (const unsigned int e : group.elements)
              for (unsigned int i = first[e]; i < first[e + 1]; ++i)
                members.push_back(i);
            group.elements = members;
          }
        // While there are the elements.
        const std::vector<std::string> notes = to_simplices ? report.warnings() : report.notes();
        file.elements                        = std::move(elements);
        return notes;
      }

      /// Append a simplex to the list of elements, and record of which faces of the file its
      /// faces at the boundary are parts.
      void
      keep(const MeshFile::Element        &cell,
           const MeshFile::Element        &element,
           std::vector<MeshFile::Element> &elements)
      {
        report.add(element, cell);
        elements.push_back(cell);
        for (const Nodes &places : CellShape::of(cell.shape).faces)
          {
            const Nodes face  = nodes_at(cell, places);
            const auto  found = whole.find(Centers::key(face));
            if (found != whole.end() && n_cells.at(Centers::key(face)) == 1)
              file.whole_faces[sorted(face)] = found->second;
          }
      }

      /// Append the children of one cell to the list of elements, one for each corner. Children of
      /// curved cells get all nodes of second order (9 or 27), so that they have exactly the shape
      /// of their part of the cell.
      void
      divide(const MeshFile::Element        &cell,
             const MeshFile::Element        &element,
             std::vector<MeshFile::Element> &elements)
      {
        const CellShape &shape  = CellShape::of(cell.shape);
        unsigned int     center = Centers::none;
        const bool       curved = is_curved(cell);
        for (unsigned int corner = 0; corner < shape.n_corners; ++corner)
          {
            const Shape       of_child = dim == 2 ? cell_shape<2> : cell_shape<3>;
            MeshFile::Element child{of_child, cell.type, cell.number, {}};
            for (const CellShape::Corners of : shape.children[corner])
              child.nodes.push_back(of == shape.all() ? center_of(cell, center) :
                                                        node_of(cell, of));
            report.add(element, child);
            if (curved)
              add_second_order(cell, corner, child);
            elements.push_back(child);
          }
        name_faces(cell);
      }

      /// @return the node at the centre of a set of corners: the corner itself, or that of an edge
      /// or face.
      unsigned int
      node_of(const MeshFile::Element &cell, const CellShape::Corners which)
      {
        const CellShape &shape = CellShape::of(cell.shape);
        Nodes            nodes;
        for (unsigned int corner = 0; corner < shape.n_corners; ++corner)
          if (which & (1u << corner))
            nodes.push_back(cell.nodes[corner]);
        if (nodes.size() == 1)
          return nodes[0];
        if (nodes.size() == 2)
          return centers.of_edge(nodes[0], nodes[1]);
        for (const Nodes &face : shape.faces)
          if (Centers::key(nodes) == Centers::key(nodes_at(cell, face)))
            return centers.of_face(nodes_at(cell, face));
        AssertThrow(false, ExcInternalError());
        return Centers::none;
      }

      /// @return the node at the centre of a cell, created at the first call if the cell has none.
      unsigned int
      center_of(const MeshFile::Element &cell, unsigned int &center)
      {
        const CellShape &shape = CellShape::of(cell.shape);
        // The last node is at the centre if it stands for all corners of the cell, as in hexahedra
        // with 27 nodes.
        if (shape.nodes[cell.nodes.size() - 1] == shape.all())
          return cell.nodes.back();
        if (center == Centers::none)
          center = centers.of_cell(corners_of(cell),
                                   value(cell, shape.second_order(cell.nodes.size()).center));
        return center;
      }

      /// @return the position that weights of the nodes of a cell give.
      Point<3>
      value(const MeshFile::Element &cell, const CellShape::Weights &weights) const
      {
        Point<3> sum;
        for (unsigned int i = 0; i < weights.size(); ++i)
          sum += weights[i] * file.nodes[cell.nodes[i]];
        return sum;
      }

      /// @return whether any node of second order is not where the nodes before it would put it, up
      /// to 1e-9 of the size of the cell.
      bool
      is_curved(const MeshFile::Element &cell) const
      {
        if (cell.nodes.size() == n_corners(cell.shape))
          return false;
        // Corners 0 and 2 are different in all shapes; their distance is used as a scale only.
        const double size = file.nodes[cell.nodes[0]].distance(file.nodes[cell.nodes[2]]);
        for (const auto &bend : CellShape::of(cell.shape).second_order(cell.nodes.size()).bends)
          if (value(cell, bend).norm() > 1e-9 * size)
            return true;
        return false;
      }

      /// Append the nodes of second order of a child, which are created without being shared:
      /// neighbours compute the same positions.
      void
      add_second_order(const MeshFile::Element &cell,
                       const unsigned int       corner,
                       MeshFile::Element       &child)
      {
        const auto &weights =
          CellShape::of(cell.shape).second_order(cell.nodes.size()).children[corner];
        for (unsigned int i = child.nodes.size(); i < weights.size(); ++i)
          {
            file.nodes.push_back(value(cell, weights[i]));
            child.nodes.push_back(file.nodes.size() - 1);
          }
      }

      /// Record in MeshFile::whole_faces of which faces of the file the faces of children at the
      /// boundary are parts.
      void
      name_faces(const MeshFile::Element &cell)
      {
        for (const Nodes &places : CellShape::of(cell.shape).faces)
          {
            const Nodes face = nodes_at(cell, places);
            if (n_cells.at(Centers::key(face)) != 1)
              continue;
            const auto         found  = whole.find(Centers::key(face));
            const Nodes       &of     = found == whole.end() ? face : found->second;
            const unsigned int n      = face.size();
            const auto         middle = [&](const unsigned int i) {
              return centers.of_edge(face[i % n], face[(i + 1) % n]);
            };
            for (unsigned int i = 0; i < n; ++i)
              if (dim == 2)
                file.whole_faces[sorted({face[i], middle(0)})] = of;
              else
                file.whole_faces[sorted(
                  {face[i], middle(i), centers.of_face(face), middle(i + n - 1)})] = of;
          }
      }

      MeshFile          &file;
      const unsigned int dim;
      const ChosenCells &chosen;
      const bool         to_simplices;
      Centers            centers;
      ShapeReport        report;

      /// The cells that are divided.
      std::vector<MeshFile::Element> cells;
      /// Index of the first cell of each element, and the end.
      std::vector<unsigned int> first_cell;

      /// Quadrilaterals of the file by each of the two triangles into which they were cut.
      std::unordered_map<Centers::Key, Nodes, Centers::Hash> whole;
      /// Number of cells at each face.
      std::unordered_map<Centers::Key, unsigned int, Centers::Hash> n_cells;
    };
  } // namespace



  std::vector<std::string>
  divide_cells(MeshFile          &file,
               const unsigned int dim,
               const std::string &part,
               const bool         mid_side_nodes)
  {
    const ChosenCells chosen(file, dim, part);
    if (!chosen.any)
      return {};
    file.first_inserted = file.nodes.size();
    return HexSubdivision(file, dim, chosen, false).divide(mid_side_nodes);
  }



  std::vector<std::string>
  cut_into_simplices(MeshFile                        &file,
                     const unsigned int               dim,
                     const std::vector<unsigned int> &cells,
                     const bool                       mid_side_nodes)
  {
    const ChosenCells chosen(file, cells);
    file.first_inserted = file.nodes.size();
    return HexSubdivision(file, dim, chosen, true).divide(mid_side_nodes);
  }
} // namespace Signorini
