// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <vector>

namespace Signorini
{
  namespace LA
  {
    /// Systems of at most so many unknowns are factorised. Further levels would only add
    /// communication.
    constexpr dealii::types::global_dof_index factorised_size = 1000;

    struct CoarseLevel
    {
      SparseMatrix matrix;       ///< P^T A P with the matrix A of the next finer level
      SparseMatrix prolongation; ///< P, to that level
    };

    /// The coarse levels of K by smoothed aggregation (ML), from finer to coarser; none if K is
    /// small. Collective.
    /// @param modes near null space of K, mode by mode: elements of this rank
    /// @param n_components unknowns of a node, which are aggregated together
    std::vector<CoarseLevel>
    smoothed_aggregation(const SparseMatrix                     &K,
                         const std::vector<std::vector<double>> &modes,
                         unsigned int                            n_components);
  } // namespace LA
} // namespace Signorini
