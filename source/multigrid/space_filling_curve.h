// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/distributed/tria.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The curve along which p4est deals out cells to ranks, in three dimensions: who owns what,
  /// known without asking. A cell with children belongs to the rank of the first leaf in it.
  class SpaceFillingCurve
  {
  public:
    using Cell = dealii::Triangulation<3>::cell_iterator;

    /// Number of the tree, and those of the children on the way down, three bits each.
    using Position = std::pair<unsigned int, std::uint64_t>;

    struct PlacedCell
    {
      Cell     cell;
      Position position; ///< of the first leaf in it
    };

    /// Collective.
    explicit SpaceFillingCurve(
      const dealii::parallel::distributed::Triangulation<3> &triangulation);

    /// Those of this rank along the curve.
    const std::vector<PlacedCell> &
    leaves() const
    {
      return my_leaves;
    }

    /// Cells with children in which there are leaves of this rank.
    const std::vector<PlacedCell> &
    ancestors() const
    {
      return my_ancestors;
    }

    /// The rank of the leaf at a position.
    unsigned int
    owner(const Position &position) const;

    /// Of the leaf at a corner of a cell.
    static Position
    at_corner(const PlacedCell &cell_on_curve, unsigned int corner);

    /// Which child of its parent a cell is. @param cell_on_curve of a cell that has a parent
    static unsigned int
    child_number(const PlacedCell &cell_on_curve);

    /// The leaf of this rank at a position.
    const PlacedCell &
    leaf(const Position &position) const;

  private:
    bool
    collect(const Cell &cell, const Position &position);

    std::vector<PlacedCell> my_leaves, my_ancestors;
    std::vector<Position>   first; ///< of each rank; those without leaves have that of the next one
  };
} // namespace Signorini
