// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

namespace Signorini
{
  namespace LA
  {
    /// dst = A src, without the two vectors that SparseMatrix::vmult allocates in each call, which
    /// matters on the coarse levels of a multigrid method.
    void
    multiply(const SparseMatrix &A, Vector &dst, const Vector &src);

    /// The product A B. Collective.
    SparseMatrix
    product(const SparseMatrix &A, const SparseMatrix &B);
  } // namespace LA
} // namespace Signorini
