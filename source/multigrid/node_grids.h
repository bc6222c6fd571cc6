// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/node_graph.h"

#include <array>
#include <cstdint>
#include <vector>

namespace Signorini
{
  /// Coordinates, of which the plane uses two.
  using Place = std::array<double, 3>;

  /// The regular grid of a connected part of a body, of which the nodes of a mesh and those of
  /// coarser grids are seen in units of its own.
  struct PartGrid
  {
    Place                       origin{};  ///< the lower corner of the part [length]
    Place                       spacing{}; ///< of the closest nodes in each direction [length]
    std::array<std::int64_t, 3> step{{1, 1, 1}}; ///< of the present grid, in spacings
  };

  /// The nodes of a level: those of this rank, then neighbours on others.
  struct GridNodes
  {
    explicit GridNodes(const std::size_t n)
      : places(n)
      , sizes(n)
      , parts(n)
    {}

    static constexpr double no_part = -1;

    std::vector<Place> places; ///< in spacings of their grid, from its origin
    /// Binary logarithms of the distance of the nodes around, in spacings: integers, at least zero.
    std::vector<double> sizes;
    std::vector<double> parts; ///< numbers of their grids, or no_part
  };

  /// The grids of all connected parts, the same on all ranks, and the nodes of this rank in them.
  /// Distances of nodes are rounded to powers of two times that with the most frequent phase:
  /// exactly those of the cells of an adaptive mesh, and the mean ones of an irregular mesh.
  /// Collective.
  /// @param positions of all local nodes [length]
  std::pair<std::vector<PartGrid>, GridNodes>
  make_grids(const LA::NodeGraph &graph, const std::vector<Place> &positions);

  /// Make a grid coarser by a factor of two in those directions in which its nodes are close.
  /// @return the factor by which it has fewer nodes
  unsigned int
  coarsen(PartGrid &grid, unsigned int dim);

  /// A node of a grid from which others are interpolated.
  struct GridCorner
  {
    std::uint64_t key; ///< its place in spacings, see place_of()
    double        weight;
  };

  /// The corners of the cell of a grid that a place is in, in the order of their keys, with the
  /// weights of multilinear interpolation; those of weight zero are left out.
  /// @param size see GridNodes: cells are larger by this power of two
  /// @return their number
  unsigned int
  find_corners(const Place               &place,
               double                     size,
               const PartGrid            &grid,
               unsigned int               dim,
               std::array<GridCorner, 8> &corners);

  /// The place of a corner.
  Place
  place_of(std::uint64_t key, unsigned int dim);

  /// Raise values to the largest of each set of items, of all ranks. Collective.
  /// @param sets items are connected on each rank
  /// @param stride number of items of each local node; neighbours are copies of nodes of other
  /// ranks
  void
  enlarge(const LA::NodeGraph &graph,
          class Connected     &sets,
          unsigned int         stride,
          std::vector<double> &values);
} // namespace Signorini
