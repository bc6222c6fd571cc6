// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/division/chosen_cells.h"
#include "mesh_import/import_steps.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the length of the shortest edge of the cells whose ends are different nodes.
    double
    shortest_edge(const MeshFile &file, const std::vector<unsigned int> &cells)
    {
      double shortest = std::numeric_limits<double>::max();
      for (const unsigned int c : cells)
        for (const auto &edge : CellShape::of(file.elements[c].shape).edges)
          {
            const unsigned int a = file.elements[c].nodes[edge[0]],
                               b = file.elements[c].nodes[edge[1]];
            if (a != b)
              shortest = std::min(shortest, file.nodes[a].distance(file.nodes[b]));
          }
      return shortest;
    }



    /// Find coinciding nodes with an R-tree, O(n log n) if few are near each other.
    /// @param reach the largest distance [length] of nodes that coincide
    /// @return for each node of the file the one that replaces it: the lowest index among those
    /// that coincide, directly or through nodes of lower index; itself for all others
    std::vector<unsigned int>
    representatives_of(const MeshFile &file, const MeshFile::Nodes &nodes, const double reach)
    {
      namespace bgi = boost::geometry::index;
      std::vector<std::pair<Point<3>, unsigned int>> places;
      for (const unsigned int node : nodes)
        places.emplace_back(file.nodes[node], node);
      const auto                tree = pack_rtree(places);
      std::vector<unsigned int> result(file.nodes.size());
      std::iota(result.begin(), result.end(), 0);
      // The nodes are in ascending order, so that result[node] is final when it is passed on to
      // those of higher index near it.
      for (const auto &[p, node] : places) // in order
        {
          BoundingBox<3> box({p, p});
          box.extend(reach);
          for (const auto &[q, other] : tree | bgi::adaptors::queried(bgi::intersects(box)))
            if (other > node && p.distance(q) <= reach)
              result[other] = std::min(result[other], result[node]);
        }
      return result;
    }
  } // namespace



  // Nodes are replaced wherever they are referred to; the unused ones stay in the list of nodes.
  void
  merge_coinciding_nodes(MeshFile          &file,
                         const unsigned int dim,
                         const std::string &part,
                         const double       distance)
  {
    const std::vector<unsigned int> cells = cells_of_part(file, dim, part);
    // Only nodes of the cells of the part are merged.
    MeshFile::Nodes nodes;
    for (const unsigned int c : cells)
      nodes.insert(nodes.end(), file.elements[c].nodes.begin(), file.elements[c].nodes.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const std::vector<unsigned int> representatives =
      representatives_of(file, nodes, distance > 0 ? distance : 1e-3 * shortest_edge(file, cells));

    const auto replace = [&](MeshFile::Nodes &list) {
      for (unsigned int &node : list)
        node = representatives[node];
    };
    for (MeshFile::Element &element : file.elements)
      replace(element.nodes);
    for (MeshFile::Group &group : file.groups)
      {
        replace(group.nodes);
        for (MeshFile::Nodes &face : group.faces)
          replace(face);
      }
    // Numbers of merged nodes remain valid: they refer to the node that replaces theirs.
    for (auto &[instance, of_instance] : file.numbers)
      for (auto &[number, node] : of_instance)
        node = representatives[node];
  }
} // namespace Signorini
