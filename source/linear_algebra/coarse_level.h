// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

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
  } // namespace LA
} // namespace Signorini
