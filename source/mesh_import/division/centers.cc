// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/division/centers.h"

#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Signorini
{
  using namespace dealii;

  // Sorted, so that neighbours with different orientation find the same entry, and padded with
  // `none`.
  Centers::Key
  Centers::key(const MeshFile::Nodes &corners)
  {
    Key result{{none, none, none, none}};
    std::copy(corners.begin(), corners.end(), result.begin());
    std::sort(result.begin(), result.end());
    return result;
  }



  // The array has eight entries, the number of corners of a hexahedron; the rest repeats the first.
  void
  Centers::store(const unsigned int node, const MeshFile::Nodes &corners)
  {
    InsertedNode one{node, {}};
    one.corners.fill(corners[0]);
    std::copy(corners.begin(), corners.end(), one.corners.begin());
    inserted_nodes.push_back(one);
  }



  // A node at the centre of the cell belongs to no edge or face, and is stored without a key.
  void
  Centers::take(const MeshFile::Element &cell)
  {
    const CellShape &shape = CellShape::of(cell.shape);
    for (unsigned int i = shape.n_corners; i < cell.nodes.size(); ++i)
      {
        const MeshFile::Nodes corners = shape.corners_around(i, cell);
        if (shape.nodes[i] == shape.all())
          {
            store(cell.nodes[i], corners);
            continue;
          }
        const auto [entry, is_new] = nodes.insert({key(corners), cell.nodes[i]});
        if (is_new)
          store(cell.nodes[i], corners);
        else if (entry->second != cell.nodes[i])
          throw SceneError("has element " + std::to_string(cell.number) + " (" + cell.type + ")" +
                           " with the mid-side node " + text_of(file.nodes[cell.nodes[i]]) +
                           " where a neighbour has another one, " +
                           text_of(file.nodes[entry->second]) +
                           "; the cells are not connected there: merge these nodes");
      }
  }



  unsigned int
  Centers::add(const MeshFile::Nodes &corners, const Point<3> &place)
  {
    file.nodes.push_back(place);
    store(file.nodes.size() - 1, corners);
    return file.nodes.size() - 1;
  }



  unsigned int
  Centers::of_edge(const unsigned int a, const unsigned int b)
  {
    const auto [entry, is_new] = nodes.insert({key({a, b}), none});
    if (is_new)
      entry->second = add({a, b}, file.nodes[a] + 0.5 * (file.nodes[b] - file.nodes[a]));
    return entry->second;
  }



  Point<3>
  Centers::center(const MeshFile::Nodes &around)
  {
    // The serendipity functions at the centre: -1/9 for corners and 4/9 for the middles of edges of
    // the triangle with six nodes, -1/4 and 1/2 for those of the quadrilateral with eight. If the
    // edges are straight, that is the mean of the corners.
    const double of_corner = around.size() == 3 ? -1. / 9 : -0.25,
                 of_middle = around.size() == 3 ? 4. / 9 : 0.5;
    Point<3> sum;
    for (unsigned int i = 0; i < around.size(); ++i)
      sum += of_corner * file.nodes[around[i]] +
             of_middle * file.nodes[of_edge(around[i], around[(i + 1) % around.size()])];
    return sum;
  }



  unsigned int
  Centers::of_face(const MeshFile::Nodes &around)
  {
    const auto found = nodes.find(key(around));
    if (found != nodes.end())
      return found->second;
    return nodes[key(around)] = add(around, center(around));
  }



  bool
  Centers::is_in_file(const MeshFile::Nodes &corners) const
  {
    const auto found = nodes.find(key(corners));
    return found != nodes.end() && found->second < n_in_file;
  }



  // If the face is curved (of second order in the file) the middle of the diagonal is the centre of
  // the face, so that the triangles follow its shape; otherwise it is the mean of both corners.
  unsigned int
  Centers::of_diagonal(const MeshFile::Nodes &around, const unsigned int a, const unsigned int b)
  {
    const auto found = nodes.find(key({a, b}));
    if (found != nodes.end())
      return found->second;
    bool second_order = is_in_file(around);
    for (unsigned int i = 0; i < around.size(); ++i)
      second_order = second_order || is_in_file({around[i], around[(i + 1) % around.size()]});
    if (!second_order)
      return of_edge(a, b);
    return nodes[key({a, b})] =
             is_in_file(around) ? nodes[key(around)] : add({a, b}, center(around));
  }



  unsigned int
  Centers::of_cell(const MeshFile::Nodes &corners, const Point<3> &place)
  {
    return add(corners, place);
  }



  void
  Centers::complete_node_sets()
  {
    std::vector<bool> contains;
    // Whether the file has a node between two corners that is not in the set, so that what is
    // around them is not a part of it.
    const auto is_left_out = [&](const unsigned int a, const unsigned int b) {
      const auto found = nodes.find(key({a, b}));
      return found != nodes.end() && found->second < n_in_file && !contains[found->second];
    };
    const auto is_within = [&](const std::array<unsigned int, 8> &corners) {
      for (const unsigned int a : corners)
        for (const unsigned int b : corners)
          if (!contains[a] || is_left_out(a, b))
            return false;
      return true;
    };
    for (MeshFile::Group &group : file.groups)
      {
        if (group.nodes.empty())
          continue;
        contains.assign(file.nodes.size(), false);
        for (const unsigned int node : group.nodes)
          contains[node] = true;
        for (const auto &[node, corners] : inserted_nodes)
          if (node >= n_in_file && is_within(corners))
            {
              contains[node] = true;
              group.nodes.push_back(node);
            }
      }
  }



  // Corners come before the nodes between them, so that one pass suffices.
  void
  Centers::complete_fields()
  {
    for (auto &[name, values] : file.fields)
      {
        values.resize(file.nodes.size(), std::numeric_limits<double>::quiet_NaN());
        // In the order in which they were made: corners come before what lies between them.
        for (const auto &[node, corners] : inserted_nodes)
          if (!std::isfinite(values[node]))
            {
              const std::set<unsigned int> distinct(corners.begin(), corners.end());
              double                       sum = 0;
              for (const unsigned int corner : distinct)
                sum += values[corner];
              values[node] = sum / distinct.size();
            }
      }
  }
} // namespace Signorini
