// SPDX-License-Identifier: Apache-2.0
#include "multigrid/levels.h"

#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The part of a cell's tangent that comes from the leaves of one rank.
    struct Message
    {
      int           level;
      unsigned int  tree;
      std::uint64_t place; ///< in the tree
      CellTangent   tangent;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &level &tree &place &tangent;
      }
    };

    /// sum += factor * term.
    void
    add(const CellTangent &term, const float factor, CellTangent &sum)
    {
      for (unsigned int k = 0; k < n_tangent_numbers; ++k)
        sum[k] += factor * term[k];
    }
  } // namespace



  LevelTangents::LevelTangents(const CellTangents      &of_leaves,
                               const SpaceFillingCurve &curve,
                               const MPI_Comm           comm)
    : of_leaves(of_leaves)
  {
    // Each leaf adds its tangent to all its ancestors, divided by four on each level
    // (doc/theory, 7.1), since both derivatives in the reference coordinates of a child are half of
    // those in its parent's.
    for (const SpaceFillingCurve::PlacedCell &leaf : curve.leaves())
      {
        const CellTangent &tangent = of_leaves[leaf.cell->active_cell_index()];
        // The sums are over the leaves of this rank only; other ranks add theirs in
        // send_to_owners().
        float                   factor = 1;
        SpaceFillingCurve::Cell cell   = leaf.cell;
        while (cell->level() > 0)
          {
            cell = cell->parent();
            factor /= 4;
            if (of_ancestors.size() <= static_cast<unsigned int>(cell->level()))
              of_ancestors.resize(cell->level() + 1);
            add(tangent, factor, of_ancestors[cell->level()][cell->index()]);
          }
      }
    send_to_owners(curve, comm);
  }



  // Cells with leaves on several ranks: partial sums are sent to the rank that owns the cell, the
  // one that has its first leaf on the curve. Collective.
  void
  LevelTangents::send_to_owners(const SpaceFillingCurve &curve, const MPI_Comm comm)
  {
    const unsigned int                           rank = Utilities::MPI::this_mpi_process(comm);
    std::map<unsigned int, std::vector<Message>> messages;
    // Level and position identify a cell on all ranks, its index in deal.II does not. A child that
    // begins where its parent does has the same position, hence the level.
    std::map<std::pair<int, SpaceFillingCurve::Position>, int> own;
    for (const SpaceFillingCurve::PlacedCell &place : curve.ancestors())
      {
        const int          level = place.cell->level(), index = place.cell->index();
        const unsigned int owner = curve.owner(place.position);
        if (owner == rank)
          own[{level, place.position}] = index;
        else
          messages[owner].push_back(
            {level, place.position.first, place.position.second, of_ancestors[level][index]});
      }
    for (const auto &[sender, parts] : Utilities::MPI::some_to_some(comm, messages))
      for (const Message &part : parts)
        add(part.tangent,
            1,
            of_ancestors[part.level].at(own.at({part.level, {part.tree, part.place}})));
  }



  // Leaves have their own tangents; other cells those of their leaves, complete on their owner
  // only.
  const CellTangent &
  LevelTangents::of(const SpaceFillingCurve::Cell &cell) const
  {
    return cell->has_children() ? of_ancestors[cell->level()].at(cell->index()) :
                                  of_leaves[cell->active_cell_index()];
  }
} // namespace Signorini
