// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/file_part_steps.h"
#include "mesh_import/pieces.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the length of the shortest edge of all cells.
    template <int dim>
    double
    shortest_edge(const std::vector<CellData<dim>> &cells, const std::vector<Point<dim>> &vertices)
    {
      double shortest = std::numeric_limits<double>::max();
      for (const auto &cell : cells)
        for (const auto &[a, b] : lines_of(cell))
          shortest = std::min(shortest, vertices[a].distance(vertices[b]));
      return shortest;
    }



    /// @return the nodes that cells use, in ascending order and each once.
    template <int dim>
    std::vector<unsigned int>
    nodes_of(const std::vector<CellData<dim>> &cells)
    {
      std::vector<unsigned int> nodes;
      for (const auto &cell : cells)
        nodes.insert(nodes.end(), cell.vertices.begin(), cell.vertices.end());
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      return nodes;
    }
  } // namespace



  // All pairs of nodes at most `distance` apart, by an R-tree: O(n log n) as long as few nodes are
  // near each other.
  template <int dim>
  CoincidingNodes<dim>::CoincidingNodes(const std::vector<CellData<dim>> &cells,
                                        const std::vector<Point<dim>>    &vertices,
                                        const double                      distance)
    : cells(cells)
    , vertices(vertices)
  {
    namespace bgi = boost::geometry::index;
    // The default is far below the size of the smallest cell, so that nodes of one cell are never
    // merged with each other, and far above the rounding of coordinates in text files.
    const double reach = distance > 0 ? distance : 1e-3 * shortest_edge(cells, vertices);
    std::vector<std::pair<Point<dim>, unsigned int>> nodes;
    for (const unsigned int node : nodes_of(cells))
      nodes.emplace_back(vertices[node], node);
    const auto tree = pack_rtree(nodes);
    for (const auto &[p, node] : nodes)
      {
        BoundingBox<dim> box({p, p});
        box.extend(reach);
        for (const auto &[q, other] : tree | bgi::adaptors::queried(bgi::intersects(box)))
          // Boxes are larger than spheres, so that the distance is checked as well; each pair is
          // stored once, with its lower node first.
          if (other > node && p.distance(q) <= reach)
            pairs.emplace_back(node, other);
      }
    std::sort(pairs.begin(), pairs.end());
  }



  // Pairs are sorted by their lower node, so that the representative of `node` is final when it is
  // passed on.
  template <int dim>
  std::vector<unsigned int>
  CoincidingNodes<dim>::representatives() const
  {
    std::vector<unsigned int> result(vertices.size());
    std::iota(result.begin(), result.end(), 0);
    for (const auto &[node, other] : pairs)
      result[other] = std::min(result[other], result[node]);
    return result;
  }



  namespace
  {
    /// @return for each vertex the number of the connected piece of the mesh to which it belongs.
    template <int dim>
    std::vector<unsigned int>
    pieces_of_vertices(const std::vector<CellData<dim>> &cells, const unsigned int n_vertices)
    {
      const std::vector<unsigned int> piece_of_cell = pieces_of(cells, n_vertices);
      std::vector<unsigned int>       piece(n_vertices);
      for (unsigned int c = 0; c < cells.size(); ++c)
        for (const unsigned int vertex : cells[c].vertices)
          piece[vertex] = piece_of_cell[c];
      return piece;
    }



    /// @return the beginning of a message about n pairs, of which the first will be named.
    std::string
    number_of_pairs(const unsigned int n)
    {
      return std::to_string(n) + (n == 1 ? " pair at " : " pairs, the first at ");
    }
  } // namespace



  // Coinciding nodes of one connected piece are a crack: an error of most meshes. Those of two
  // pieces may be bodies in contact, and are only reported.
  template <int dim>
  std::string
  CoincidingNodes<dim>::reject_cracks() const
  {
    const std::vector<unsigned int> piece = pieces_of_vertices(cells, vertices.size());
    std::vector<unsigned int>       cracks, between; // first nodes
    for (const auto &[node, other] : pairs)
      // Within a piece, the two nodes are connected by other cells, so that the gap between them is
      // a crack; between two pieces it may be a contact.
      (piece[node] == piece[other] ? cracks : between).push_back(node);
    if (!cracks.empty())
      throw SceneError(
        "has nodes that coincide, at which cells that are connected elsewhere are not: " +
        number_of_pairs(cracks.size()) + text_of(vertices[cracks[0]]) +
        "; set Coinciding nodes = keep for a crack or a slit, or Coinciding nodes = merge to connect the cells");
    if (between.empty())
      return "";
    return "has pieces that touch, but are not connected: they have separate nodes at the same positions, " +
           number_of_pairs(between.size()) + text_of(vertices[between[0]]) +
           "; if they are in contact, make each a body by the key 'Part', or define a contact pair "
           "of two boundaries of this body; if they do not interact, set Coinciding nodes = keep; if "
           "they are one piece, set Coinciding nodes = merge";
  }



  // Each edge between nodes at the boundary is compared with the nodes at the boundary in its
  // bounding box. A node is on the edge if it is closer than 1e-4 of the length of the edge, and
  // not within 1 % of its ends.
  template <int dim>
  void
  reject_hanging_nodes(const std::vector<CellData<dim>>     &cells,
                       const std::vector<CellData<dim - 1>> &boundary_faces,
                       const std::vector<Point<dim>>        &vertices)
  {
    namespace bgi = boost::geometry::index;
    // Only nodes at the boundary can hang.
    std::vector<bool> at_boundary(vertices.size());
    for (const auto &face : boundary_faces)
      for (const unsigned int vertex : face.vertices)
        at_boundary[vertex] = true;
    std::vector<std::pair<Point<dim>, unsigned int>> nodes;
    for (unsigned int vertex = 0; vertex < vertices.size(); ++vertex)
      if (at_boundary[vertex])
        nodes.emplace_back(vertices[vertex], vertex);
    const auto                      tree  = pack_rtree(nodes);
    const std::vector<unsigned int> piece = pieces_of_vertices(cells, vertices.size());
    constexpr double                near  = 1e-4; // of the edge
    for (const auto &cell : cells)
      for (const auto &[a, b] : lines_of(cell))
        {
          // Where cells are not connected, the faces on both sides are boundary faces, so that both
          // ends of the edge are at the boundary.
          if (!at_boundary[a] || !at_boundary[b])
            continue;
          // The candidates are the nodes in the bounding box of the edge.
          const Tensor<1, dim> edge   = vertices[b] - vertices[a];
          const double         length = edge.norm();
          BoundingBox<dim>     box({vertices[a], vertices[a]});
          box.merge_with(BoundingBox<dim>({vertices[b], vertices[b]}));
          box.extend(near * length);
          for (const auto &[x, node] : tree | bgi::adaptors::queried(bgi::intersects(box)))
            {
              const Tensor<1, dim> offset = x - vertices[a];
              // Position of the projection of the node along the edge, from 0 at a to 1 at b.
              const double along = offset * edge / (length * length);
              if (piece[node] == piece[a] && along > 0.01 && along < 0.99 &&
                  (offset - along * edge).norm() < near * length)
                throw SceneError(
                  "has a node at " + text_of(x) + " on the edge of a cell from " +
                  text_of(vertices[a]) + " to " + text_of(vertices[b]) +
                  " without that node: cells of different sizes are not connected there; make the "
                  "mesh conforming, make the parts bodies with a contact pair, or set Coinciding "
                  "nodes = keep for a crack or a slit");
            }
        }
  }



  template class CoincidingNodes<2>;
  template class CoincidingNodes<3>;
  template void
  reject_hanging_nodes(const std::vector<CellData<2>> &,
                       const std::vector<CellData<1>> &,
                       const std::vector<Point<2>> &);
  template void
  reject_hanging_nodes(const std::vector<CellData<3>> &,
                       const std::vector<CellData<2>> &,
                       const std::vector<Point<3>> &);
} // namespace Signorini
