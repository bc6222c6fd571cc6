// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/grid/cell_id.h>

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace Signorini
{
  /// A slave face of a contact pair, identified independently of ranks and partitions.
  struct FaceId
  {
    unsigned int   pair = 0;
    dealii::CellId cell;
    unsigned int   face = 0; ///< of the cell

    bool
    operator<(const FaceId &other) const
    {
      return std::tie(pair, cell, face) < std::tie(other.pair, other.cell, other.face);
    }

    template <class Archive>
    void
    serialize(Archive &ar, const unsigned int)
    {
      ar &pair &cell &face;
    }
  };

  /// The parameters of a point of a face, in [0,1]; those of a line have a zero behind.
  using SurfacePoint = std::array<double, 2>;

  /// The contact points on a slave face: each position, with the rows of the gap operator that
  /// determine the value there: one row, or those that a hanging node is condensed to, with their
  /// weights; none where there is no projection.
  struct SurfacePoints
  {
    FaceId id;
    std::vector<
      std::pair<SurfacePoint, std::vector<std::pair<dealii::types::global_dof_index, double>>>>
      places;
  };
} // namespace Signorini
