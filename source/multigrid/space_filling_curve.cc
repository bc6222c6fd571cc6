// SPDX-License-Identifier: Apache-2.0
#include "multigrid/space_filling_curve.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The position of the bits of a child's number in a position on the curve (three bits for each
    /// level, the coarsest first); p4est has fewer levels than fit.
    unsigned int
    shift(const unsigned int level)
    {
      constexpr unsigned int levels = 21;
      return 3 * (levels - 1 - level);
    }

    /// Order by position, first by tree, then along the curve in the tree.
    bool
    comes_before(const SpaceFillingCurve::PlacedCell &a, const SpaceFillingCurve::PlacedCell &b)
    {
      return a.position < b.position;
    }
  } // namespace



  SpaceFillingCurve::SpaceFillingCurve(const parallel::distributed::Triangulation<3> &triangulation)
  {
    // p4est orders the trees differently from the coarse cells of deal.II. Its order is used,
    // because the leaves are distributed along it.
    const auto &trees = triangulation.get_coarse_cell_to_p4est_tree_permutation();
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      collect(cell, {static_cast<unsigned int>(trees[cell->index()]), 0});
    std::sort(my_leaves.begin(), my_leaves.end(), comes_before);

    constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
    first                       = Utilities::MPI::all_gather(triangulation.get_communicator(),
                                       my_leaves.empty() ? Position(none, 0) :
                                                                                 my_leaves.front().position);
    // Ranks without leaves get the first position of the next rank, so that owner() finds none on
    // them.
    for (unsigned int rank = first.size(); rank-- > 0;)
      if (first[rank].first == none && rank + 1 < first.size())
        first[rank] = first[rank + 1];
  }



  // Collect the leaves of this rank below a cell, and the ancestors that have such leaves. Returns
  // true if there are any.
  bool
  SpaceFillingCurve::collect(const Cell &cell, const Position &position)
  {
    // Artificial and ghost leaves are not collected: their positions are on other ranks.
    if (!cell->has_children())
      {
        if (cell->is_locally_owned())
          my_leaves.push_back({cell, position});
        return cell->is_locally_owned();
      }
    bool any = false;
    for (unsigned int k = 0; k < cell->n_children(); ++k)
      {
        const std::uint64_t step = std::uint64_t(k) << shift(cell->level());
        any |= collect(cell->child(k), {position.first, position.second | step});
      }
    if (any)
      my_ancestors.push_back({cell, position});
    return any;
  }



  // Leaves are distributed in the order of the curve; the owner of a position is the last rank
  // whose first leaf is not behind it.
  unsigned int
  SpaceFillingCurve::owner(const Position &position) const
  {
    return std::upper_bound(first.begin(), first.end(), position) - first.begin() - 1;
  }



  // The leaf at a corner of a cell: the child with the number of the corner on all finer levels.
  SpaceFillingCurve::Position
  SpaceFillingCurve::at_corner(const PlacedCell &cell_on_curve, const unsigned int corner)
  {
    Position position = cell_on_curve.position;
    // Levels beyond the finest one are filled too; the position is then inside of the leaf, and
    // owner() and leaf() find the interval that contains it.
    for (unsigned int level = cell_on_curve.cell->level(); level < 21; ++level)
      position.second |= std::uint64_t(corner) << shift(level);
    return position;
  }



  unsigned int
  SpaceFillingCurve::child_number(const PlacedCell &cell_on_curve)
  {
    return cell_on_curve.position.second >> shift(cell_on_curve.cell->level() - 1) & 7;
  }



  // The leaf of this rank that contains a position: the last one that does not begin behind it.
  const SpaceFillingCurve::PlacedCell &
  SpaceFillingCurve::leaf(const Position &position) const
  {
    const auto behind = std::upper_bound(my_leaves.begin(),
                                         my_leaves.end(),
                                         position,
                                         [](const Position &p, const PlacedCell &cell_on_curve) {
                                           return p < cell_on_curve.position;
                                         });
    Assert(behind != my_leaves.begin(), ExcInternalError());
    return *std::prev(behind);
  }
} // namespace Signorini
