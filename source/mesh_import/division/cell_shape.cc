// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/division/cell_shape.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <memory>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Shape = MeshFile::Shape;
    using Nodes = MeshFile::Nodes;

    /// The tables of a shape. A corner is written with one digit for each simplex: the number of
    /// the corner of the simplex.
    struct Facts
    {
      /// The number of corners of each simplex of the product.
      Nodes simplices;
      /// Corners, edges and faces; `centers` are the corners around each node of second order
      /// behind those of the edges, in the order of MeshFile::Element.
      std::vector<Nodes> corners, edges, faces, centers;
    };

    /// @return the tables of a shape, in the numbering of MeshFile::Element. Throws for points and
    /// lines.
    Facts
    facts(const Shape shape)
    {
      switch (shape)
        {
          case Shape::triangle:
            return {{3}, {{0}, {1}, {2}}, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1}, {1, 2}, {2, 0}}, {}};
          case Shape::quadrilateral:
            return {{2, 2},
                    {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                    {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                    {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                    {{0, 1, 2, 3}}};
          case Shape::tetrahedron:
            return {{4},
                    {{0}, {1}, {2}, {3}},
                    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}},
                    {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                    {}};
          case Shape::wedge:
            return {{3, 2},
                    {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}},
                    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}},
                    {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}, {0, 1, 2}, {3, 4, 5}},
                    {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
          case Shape::hexahedron:
            return {
              {2, 2, 2},
              {{0, 0, 0},
               {1, 0, 0},
               {1, 1, 0},
               {0, 1, 0},
               {0, 0, 1},
               {1, 0, 1},
               {1, 1, 1},
               {0, 1, 1}},
              {{0, 1},
               {1, 2},
               {2, 3},
               {3, 0},
               {4, 5},
               {5, 6},
               {6, 7},
               {7, 4},
               {0, 4},
               {1, 5},
               {2, 6},
               {3, 7}},
              {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}},
              {{0, 3, 7, 4},
               {1, 2, 6, 5},
               {0, 1, 5, 4},
               {3, 2, 6, 7},
               {0, 1, 2, 3},
               {4, 5, 6, 7},
               {0, 1, 2, 3, 4, 5, 6, 7}}};
          case Shape::pyramid:
            // Not a product: the digits are the coordinates.
            return {{2, 2, 2},
                    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}},
                    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}},
                    {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                    {{0, 1, 2, 3}}};
          default:
            AssertThrow(false, ExcInternalError());
            return {};
        }
    }



    /// @return a list of corners as a set of bits.
    CellShape::Corners
    set_of(const Nodes &corners)
    {
      CellShape::Corners set = 0;
      for (const unsigned int corner : corners)
        set |= 1u << corner;
      return set;
    }



    bool
    contains(const CellShape::Corners set, const CellShape::Corners other)
    {
      return (set & other) == other;
    }
  } // namespace



  // Corners as barycentric coordinates, one simplex after the other; nodes as sets of corners.
  CellShape::CellShape(const Shape shape)
    : dim(dimension_of(shape))
    , n_corners(Signorini::n_corners(shape))
  {
    const Facts all_facts = facts(shape);
    simplices             = all_facts.simplices;
    edges                 = all_facts.edges;
    faces                 = all_facts.faces;
    for (const Nodes &digits : all_facts.corners)
      {
        corners.emplace_back();
        for (unsigned int s = 0; s < simplices.size(); ++s)
          for (unsigned int i = 0; i < simplices[s]; ++i)
            corners.back().push_back(digits[s] == i);
      }
    for (unsigned int corner = 0; corner < n_corners; ++corner)
      nodes.push_back(1u << corner);
    for (const auto &list : {all_facts.edges, all_facts.centers})
      for (const Nodes &center : list)
        nodes.push_back(set_of(center));
    if (shape != Shape::pyramid)
      add_children();
  }



  const CellShape &
  CellShape::of(const Shape shape)
  {
    static std::map<Shape, std::unique_ptr<CellShape>> shapes;
    std::unique_ptr<CellShape>                        &entry = shapes[shape];
    if (!entry)
      entry.reset(new CellShape(shape));
    return *entry;
  }



  // Bits of the set in ascending order of the corners.
  Nodes
  CellShape::corners_around(const unsigned int i, const MeshFile::Element &cell) const
  {
    Nodes result;
    for (unsigned int corner = 0; corner < n_corners; ++corner)
      if (nodes[i] & (1u << corner))
        result.push_back(cell.nodes[corner]);
    return result;
  }



  double
  CellShape::orientation(const Nodes &which) const
  {
    // The barycentric coordinates of each simplex but the first one are Cartesian coordinates of
    // the reference cell.
    std::vector<Tensor<1, 3>> points(which.size());
    for (unsigned int i = 0; i < which.size(); ++i)
      for (unsigned int s = 0, l = 0, d = 0; s < simplices.size(); ++s)
        for (unsigned int j = 0; j < simplices[s]; ++j, ++l)
          if (j > 0)
            points[i][d++] = corners[which[i]][l];
    const Tensor<1, 3> a = points[1] - points[0], b = points[2] - points[0];
    return dim == 2 ? cross_product_3d(a, b)[2] : cross_product_3d(a, b) * (points[3] - points[0]);
  }



  // The child at a corner is spanned by the three edges there (2D: two), in an order of positive
  // orientation. Its corners, in the order of MeshFile: the corner, the middles of two edges and
  // the centre of the face between them around the bottom; above these those of the third edge.
  void
  CellShape::add_children()
  {
    for (unsigned int corner = 0; corner < n_corners; ++corner)
      {
        Nodes fan{corner};
        for (const Nodes &edge : edges)
          if (edge[0] == corner || edge[1] == corner)
            fan.push_back(edge[0] + edge[1] - corner);
        if (orientation(fan) < 0)
          std::swap(fan[1], fan[2]);

        const auto edge = [&](const unsigned int i) { return set_of({corner, fan[i]}); };
        const auto face = [&](const unsigned int i, const unsigned int j) {
          for (const Nodes &around : faces)
            if (contains(set_of(around), set_of({corner, fan[i], fan[j]})))
              return set_of(around);
          return all();
        };
        children.push_back({1u << corner, edge(1), face(1, 2), edge(2)});
        if (dim == 3)
          for (const Corners top : {edge(3), face(1, 3), all(), face(2, 3)})
            children.back().push_back(top);
      }
  }



  // The mean of the points whose bits are set.
  CellShape::Coordinates
  CellShape::center_of(const std::vector<Coordinates> &points, const Corners which) const
  {
    Coordinates  sum(points[0].size());
    unsigned int n = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      if (which & (1u << i))
        {
          ++n;
          for (unsigned int l = 0; l < sum.size(); ++l)
            sum[l] += points[i][l];
        }
    for (double &coordinate : sum)
      coordinate /= n;
    return sum;
  }



  // The product over all simplices of L_i (a node at a corner of the simplex) or 4 L_i L_j (a node
  // in the middle of its edge): a function that is 1 at its own node, in the sense of a
  // hierarchical basis.
  double
  CellShape::function(const Corners node, const Coordinates &point) const
  {
    const Coordinates center = center_of(corners, node);
    double            value  = 1;
    for (unsigned int s = 0, first = 0; s < simplices.size(); first += simplices[s++])
      {
        unsigned int n = 0;
        for (unsigned int l = first; l < first + simplices[s]; ++l)
          if (center[l] > 0)
            {
              value *= point[l];
              ++n;
            }
        if (n == 2)
          value *= 4;
      }
    return value;
  }



  CellShape::Weights
  CellShape::weights(const unsigned int n_nodes, const Coordinates &point) const
  {
    // The functions are hierarchical: each vanishes at the nodes before its own. From the last node
    // backwards, the weight is its function minus what the weights of later nodes contribute to it.
    Weights result(n_nodes);
    for (unsigned int i = n_nodes; i-- > 0;)
      {
        result[i] = function(nodes[i], point);
        for (unsigned int later = i + 1; later < n_nodes; ++later)
          result[i] -= result[later] * function(nodes[i], center_of(corners, nodes[later]));
      }
    return result;
  }



  // The weights are computed once for each number of nodes and kept; the number says which nodes of
  // second order the cell has (for example 20 or 27 of a hexahedron).
  const CellShape::SecondOrder &
  CellShape::second_order(const unsigned int n_nodes) const
  {
    const auto [entry, is_new] = by_n_nodes.insert({n_nodes, {}});
    SecondOrder &result        = entry->second;
    if (!is_new)
      return result;
    // Positions of the nodes of each child are interpolated from the nodes of the cell.
    const CellShape &small = of(dim == 2 ? Shape::quadrilateral : Shape::hexahedron);
    for (const std::vector<Corners> &child : children)
      {
        std::vector<Coordinates> ends;
        for (const Corners corner : child)
          ends.push_back(center_of(corners, corner));
        result.children.emplace_back();
        for (const Corners node : small.nodes)
          result.children.back().push_back(weights(n_nodes, center_of(ends, node)));
      }
    for (unsigned int i = n_corners; i < n_nodes; ++i)
      {
        // The offset of a node from the position that the nodes before it define.
        Weights bend = weights(i, center_of(corners, nodes[i]));
        for (double &weight : bend)
          weight = -weight;
        bend.push_back(1);
        result.bends.push_back(bend);
      }
    result.center = weights(n_nodes, center_of(corners, all()));
    return result;
  }



  MeshFile::Nodes
  nodes_at(const MeshFile::Element &element, const MeshFile::Nodes &positions)
  {
    MeshFile::Nodes nodes;
    for (const unsigned int position : positions)
      nodes.push_back(element.nodes[position]);
    return nodes;
  }
} // namespace Signorini
