// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/division/subdivisions.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Nodes = MeshFile::Nodes;

    /// A cell that is divided into triangles or tetrahedra. Its corners are numbered locally
    /// ("places" 0, 1,
    /// ...).
    class Cell
    {
    public:
      Cell(const MeshFile::Element &element, MeshFile &file, Centers &centers)
        : element(element)
        , shape(CellShape::of(element.shape))
        , file(file)
        , centers(centers)
      {}

      /// @return the triangles or tetrahedra: cones from the corner with the lowest node number
      /// over the edges, or the triangles of the faces, that do not contain it.
      std::vector<MeshFile::Element>
      simplices()
      {
        const unsigned int             lowest = place_of_lowest(corners_of(element));
        std::vector<MeshFile::Element> result;
        for (const Nodes &face : shape.faces)
          if (std::find(face.begin(), face.end(), lowest) == face.end())
            for (Nodes places : divided(face))
              {
                places.push_back(lowest);
                result.push_back(simplex(places));
              }
        return result;
      }

    private:
      /// @return the position of the lowest node number.
      static unsigned int
      place_of_lowest(const Nodes &nodes)
      {
        return std::min_element(nodes.begin(), nodes.end()) - nodes.begin();
      }

      /// @return the edge, or the triangles of a face, as local corners. A quadrilateral is cut by
      /// the diagonal from its lowest node number, on which both cells at the face agree.
      std::vector<Nodes>
      divided(const Nodes &face) const
      {
        if (face.size() < 4)
          return {face};
        Nodes nodes;
        for (const unsigned int corner : face)
          nodes.push_back(element.nodes[corner]);
        const unsigned int i = place_of_lowest(nodes);
        return {{face[i], face[(i + 1) % 4], face[(i + 2) % 4]},
                {face[i], face[(i + 2) % 4], face[(i + 3) % 4]}};
      }

      /// @return the triangle or tetrahedron of three or four local corners, oriented positively;
      /// of second order if the cell is.
      MeshFile::Element
      simplex(Nodes places)
      {
        if (shape.orientation(places) < 0)
          std::swap(places[0], places[1]);
        MeshFile::Element result{shape.dim == 2 ? simplex_shape<2> : simplex_shape<3>,
                                 element.type,
                                 element.number,
                                 {}};
        for (const unsigned int place : places)
          result.nodes.push_back(element.nodes[place]);
        if (element.nodes.size() > shape.n_corners)
          for (const Nodes &edge : CellShape::of(result.shape).edges)
            result.nodes.push_back(middle(places[edge[0]], places[edge[1]]));
        return result;
      }

      /// @return the node in the middle of two local corners: that of an edge, of a diagonal of a
      /// face, or the centre of the cell.
      unsigned int
      middle(const unsigned int a, const unsigned int b)
      {
        const unsigned int from = element.nodes[a], to = element.nodes[b];
        for (const Nodes &edge : shape.edges)
          if (std::minmax(a, b) == std::minmax(edge[0], edge[1]))
            return centers.of_edge(from, to);
        for (const Nodes &face : shape.faces)
          if (std::count(face.begin(), face.end(), a) && std::count(face.begin(), face.end(), b))
            {
              Nodes around;
              for (const unsigned int corner : face)
                around.push_back(element.nodes[corner]);
              return centers.of_diagonal(around, from, to);
            }
        // The parts of this simplex, if it is divided further, find it by the same two corners.
        centers.set_middle(from, to, center());
        return center();
      }

      /// @return the node at the centre of a cell. All simplices around its inner diagonal share
      /// it.
      unsigned int
      center()
      {
        if (shape.nodes[element.nodes.size() - 1] == shape.all())
          return element.nodes.back();
        if (my_center == Centers::none)
          {
            const auto &weights = shape.second_order(element.nodes.size()).center;
            Point<3>    place;
            for (unsigned int i = 0; i < weights.size(); ++i)
              place += weights[i] * file.nodes[element.nodes[i]];
            my_center = centers.of_cell(corners_of(element), place);
          }
        return my_center;
      }

      const MeshFile::Element &element;
      const CellShape         &shape;
      MeshFile                &file;
      Centers                 &centers;
      unsigned int             my_center = Centers::none;
    };
  } // namespace



  std::vector<MeshFile::Element>
  simplices_of(const MeshFile::Element &cell, MeshFile &file, Centers &centers)
  {
    if (cell.shape == simplex_shape<2> || cell.shape == simplex_shape<3>)
      return {cell};
    return Cell(cell, file, centers).simplices();
  }



  std::vector<MeshFile::Nodes>
  triangles_of(const Nodes &around)
  {
    const unsigned int i = std::min_element(around.begin(), around.end()) - around.begin();
    return {{around[i], around[(i + 1) % 4], around[(i + 2) % 4]},
            {around[i], around[(i + 2) % 4], around[(i + 3) % 4]}};
  }
} // namespace Signorini
