// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/import_steps.h"

#include <algorithm>
#include <set>

namespace Signorini
{
  namespace
  {
    using Shape = MeshFile::Shape;
    using Nodes = MeshFile::Nodes;

    bool
    contains(const Nodes &nodes, const unsigned int node)
    {
      return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    }



    /// @return whether an element lists a node more than once among its corners.
    bool
    has_repeated_corners(const MeshFile::Element &element)
    {
      const unsigned int n = n_corners(element.shape);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < i; ++j)
          if (element.nodes[i] == element.nodes[j])
            return true;
      return false;
    }



    /// A hexahedron (2D: quadrilateral) with repeated corners. Its faces without repetitions, and
    /// without those that have collapsed to an edge or a point or are the same as another, say
    /// which shape it has: three quadrilaterals and two triangles are a wedge, one and four a
    /// pyramid, four triangles a tetrahedron.
    class Collapsed
    {
    public:
      explicit Collapsed(const MeshFile::Element &element)
        : element(element)
        , shape(CellShape::of(element.shape))
        , distinct(element.nodes.begin(), element.nodes.begin() + shape.n_corners)
      {
        std::set<Nodes> known;
        for (const Nodes &face : shape.faces)
          {
            Nodes around;
            for (const unsigned int place : face)
              if (!contains(around, element.nodes[place]))
                around.push_back(element.nodes[place]);
            if (around.size() >= shape.dim && known.insert(sorted(around)).second)
              (around.size() == 4 ? squares : triangles).push_back(around);
          }
      }

      /// @return the element with the shape that it really has; unchanged if that is none of the
      /// known ones.
      MeshFile::Element
      recognised() const
      {
        MeshFile::Element result = element;
        const Nodes       list   = corners();
        if (list.empty())
          return element;
        result.shape = shape.dim == 2   ? Shape::triangle :
                       list.size() == 6 ? Shape::wedge :
                       list.size() == 5 ? Shape::pyramid :
                                          Shape::tetrahedron;
        result.nodes = list;
        return add_middles(result) ? result : element;
      }

    private:
      /// @return the corners in the order of the new shape; empty if the shape is not a known one.
      Nodes
      corners() const
      {
        if (shape.dim == 2)
          return distinct.size() == 3 ? around_plane() : Nodes();
        if (distinct.size() == 6 && squares.size() == 3 && triangles.size() == 2)
          return wedge();
        if (distinct.size() == 5 && squares.size() == 1 && triangles.size() == 4)
          return with_apex(squares[0]);
        if (distinct.size() == 4 && squares.empty() && triangles.size() == 4)
          return with_apex(triangles[0]);
        return {};
      }

      /// @return the distinct corners, in their order around the cell.
      Nodes
      around_plane() const
      {
        Nodes result;
        for (unsigned int i = 0; i < shape.n_corners; ++i)
          if (!contains(result, element.nodes[i]))
            result.push_back(element.nodes[i]);
        return result;
      }

      /// @return the corners of a base and the first corner that is not in it, which is the apex.
      Nodes
      with_apex(Nodes base) const
      {
        for (const unsigned int node : distinct)
          if (!contains(base, node))
            {
              base.push_back(node);
              break;
            }
        return base;
      }

      /// @return the corners of a wedge. Above each corner of one triangle is its neighbour in the
      /// quadrilaterals that is not in the triangle.
      Nodes
      wedge() const
      {
        Nodes result = triangles[0];
        for (unsigned int i = 0; i < 3; ++i)
          for (const Nodes &square : squares)
            {
              const auto at = std::find(square.begin(), square.end(), triangles[0][i]);
              if (at == square.end())
                continue;
              const unsigned int place = at - square.begin(), next = square[(place + 1) % 4],
                                 previous = square[(place + 3) % 4];
              result.push_back(contains(triangles[0], next) ? previous : next);
              break;
            }
        return result;
      }

      /// Append the nodes of second order in the middle of the edges of the new shape, which are
      /// those of the collapsed element.
      /// @return false if some are missing
      bool
      add_middles(MeshFile::Element &result) const
      {
        if (element.nodes.size() == shape.n_corners)
          return true;
        std::map<std::pair<unsigned int, unsigned int>, unsigned int> middles;
        for (unsigned int i = 0; i < shape.edges.size(); ++i)
          middles.insert(
            {std::minmax({element.nodes[shape.edges[i][0]], element.nodes[shape.edges[i][1]]}),
             element.nodes[shape.n_corners + i]});
        for (const Nodes &edge : CellShape::of(result.shape).edges)
          {
            const auto found =
              middles.find(std::minmax({result.nodes[edge[0]], result.nodes[edge[1]]}));
            if (found == middles.end())
              return false;
            result.nodes.push_back(found->second);
          }
        return true;
      }

      const MeshFile::Element     &element;
      const CellShape             &shape;
      const std::set<unsigned int> distinct;
      /// The faces that have four or three different corners, in cyclic order.
      std::vector<Nodes> squares, triangles;
    };
  } // namespace



  void
  recognise_collapsed_cells(MeshFile &file, const std::vector<unsigned int> &elements)
  {
    for (const unsigned int e : elements)
      {
        MeshFile::Element &element = file.elements[e];
        if (element.shape != Shape::hexahedron && element.shape != Shape::quadrilateral)
          continue;
        if (has_repeated_corners(element))
          element = MeshFile::Element(Collapsed(element).recognised());
      }
  }
} // namespace Signorini
