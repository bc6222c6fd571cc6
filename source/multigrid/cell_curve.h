#pragma once

#include <deal.II/distributed/tria.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The curve along which p4est deals out cells to ranks, in three dimensions: who owns what,
  /// known without asking. A cell with children belongs to the rank of the first leaf in it.
  class CellCurve
  {
  public:
    using Cell = dealii::Triangulation<3>::cell_iterator;

    /// Number of the tree, and those of the children on the way down, three bits each.
    using Position = std::pair<unsigned int, std::uint64_t>;

    struct Place
    {
      Cell     cell;
      Position position; ///< of the first leaf in it
    };

    /// Collective.
    explicit CellCurve(const dealii::parallel::distributed::Triangulation<3> &triangulation);

    /// Those of this rank along the curve.
    const std::vector<Place> &
    leaves() const
    {
      return my_leaves;
    }

    /// Cells with children in which there are leaves of this rank.
    const std::vector<Place> &
    ancestors() const
    {
      return my_ancestors;
    }

    /// The rank of the leaf at a position.
    unsigned int
    owner(const Position &position) const;

    /// Of the leaf at a corner of a cell.
    static Position
    at_corner(const Place &place, unsigned int corner);

    /// Which child of its parent a cell is. @param place of a cell that has a parent
    static unsigned int
    child_number(const Place &place);

    /// The leaf of this rank at a position.
    const Place &
    leaf(const Position &position) const;

  private:
    bool
    collect(const Cell &cell, const Position &position);

    std::vector<Place>    my_leaves, my_ancestors;
    std::vector<Position> first; ///< of each rank; those without leaves have that of the next one
  };
} // namespace Signorini
