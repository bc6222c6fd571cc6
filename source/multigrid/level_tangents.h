// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "multigrid/space_filling_curve.h"
#include "solid/cell_tangents.h"

#include <unordered_map>
#include <vector>

namespace Signorini
{
  /// Tangents of the cells of coarser meshes. A derivative in a child's unit coordinates is half of
  /// that in its parent's: where gradients do not change in the parent, its tangent is a quarter of
  /// the sum of those of its children.
  class LevelTangents
  {
  public:
    /// Refers to the tangents of the leaves. Collective.
    LevelTangents(const CellTangents &of_leaves, const SpaceFillingCurve &curve, MPI_Comm comm);

    /// The tangent of a leaf of this rank, or of a cell with children that this rank owns.
    const CellTangent &
    of(const SpaceFillingCurve::Cell &cell) const;

  private:
    void
    send_to_owners(const SpaceFillingCurve &curve, MPI_Comm comm);

    const CellTangents                               &of_leaves;
    std::vector<std::unordered_map<int, CellTangent>> of_ancestors; ///< [level], by index
  };
} // namespace Signorini
