// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

namespace Signorini
{
  namespace LA
  {
    /// dst = A src, as SparseMatrix::vmult, which allocates two vectors a call: on the coarse
    /// levels of a multigrid method that counts.
    void
    multiply(const SparseMatrix &A, Vector &dst, const Vector &src);

    /// A B
    SparseMatrix
    product(const SparseMatrix &A, const SparseMatrix &B);
  } // namespace LA
} // namespace Signorini
