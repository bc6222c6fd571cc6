// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// @return of the nodes of a triangle or tetrahedron of second order the one in the middle of two
  /// vertices; the vertex itself if both are the same. Vertices come first, then the middles of the
  /// edges 01, 12, 20, 03, 13, 23, which is the order of deal.II.
  /// @param a,b numbers of vertices
  template <int dim>
  constexpr unsigned int
  node_between(const unsigned int a, const unsigned int b)
  {
    constexpr unsigned int edges[4][4] = {{0, 0, 2, 3}, {0, 0, 1, 4}, {2, 1, 0, 5}, {3, 4, 5, 0}};
    return a == b ? a : dim + 1 + edges[a][b];
  }
} // namespace Signorini
