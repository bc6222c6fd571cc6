// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/distributed/tria.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The space-filling curve by which p4est distributes cells in three dimensions; it determines
  /// the owner of any cell without communication. A cell with children belongs to the rank of its
  /// first leaf.
  class SpaceFillingCurve
  {
  public:
    using Cell = dealii::Triangulation<3>::cell_iterator;

    /// Position on the curve: number of the tree, and the child numbers from the root down, three
    /// bits each.
    using Position = std::pair<unsigned int, std::uint64_t>;

    /// A cell with its position on the curve.
    struct PlacedCell
    {
      Cell cell;
      /// The position of its first leaf.
      Position position;
    };

    /// Find the leaves of this rank and the first position of each rank. Collective.
    explicit SpaceFillingCurve(
      const dealii::parallel::distributed::Triangulation<3> &triangulation);

    /// The leaves of this rank in the order of the curve.
    const std::vector<PlacedCell> &
    leaves() const
    {
      return my_leaves;
    }

    /// The ancestors of this rank's leaves.
    const std::vector<PlacedCell> &
    ancestors() const
    {
      return my_ancestors;
    }

    /// The rank of the leaf at a position.
    unsigned int
    owner(const Position &position) const;

    /// The position of the leaf at a corner of a cell.
    static Position
    at_corner(const PlacedCell &cell_on_curve, unsigned int corner);

    /// The number of a cell among the children of its parent. @param cell_on_curve a cell that has
    /// a parent
    static unsigned int
    child_number(const PlacedCell &cell_on_curve);

    /// The leaf of this rank at a position.
    const PlacedCell &
    leaf(const Position &position) const;

  private:
    /// See the constructor; for a cell and its descendants.
    bool
    collect(const Cell &cell, const Position &position);

    std::vector<PlacedCell> my_leaves, my_ancestors;
    /// The first position of each rank; ranks without leaves have that of the next one.
    std::vector<Position> first;
  };
} // namespace Signorini
