// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <vector>

namespace Signorini
{
  namespace LA
  {
    struct CoarseLevel
    {
      SparseMatrix matrix;       ///< P^T A P with the matrix A of the next finer level
      SparseMatrix prolongation; ///< P, to that level
    };

    /// The coarse levels that ML makes of K by smoothed aggregation, from finer to coarser; none if
    /// K is small. Collective.
    /// @param modes near-null-space of K: elements of this rank, mode by mode
    /// @param n_components unknowns of a node, which aggregates do not tear apart
    std::vector<CoarseLevel>
    smoothed_aggregation(const SparseMatrix                     &K,
                         const std::vector<std::vector<double>> &modes,
                         unsigned int                            n_components);
  } // namespace LA
} // namespace Signorini
