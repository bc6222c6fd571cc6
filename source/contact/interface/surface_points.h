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

  /// A position on a slave face, and the rows of the gap operator that determine the value there,
  /// with their weights.
  struct SurfacePlace
  {
    SurfacePoint point;
    /// The row at this position, or those that a hanging node or a node without pressure of its own
    /// depends on; none where there is no projection.
    std::vector<std::pair<dealii::types::global_dof_index, double>> rows;
    /// True if this is the position of the row, which is then the only one.
    bool is_row;
  };

  /// The contact points on a slave face.
  struct SurfacePoints
  {
    FaceId                    id;
    std::vector<SurfacePlace> places;
  };
} // namespace Signorini
