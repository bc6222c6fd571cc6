// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

namespace Signorini
{
  namespace LA
  {
    /// The diagonal of a square matrix.
    Vector
    diagonal(const SparseMatrix &matrix);

    /// Add positive terms to the diagonal of a square matrix whose pattern has it, and compress;
    /// other terms are skipped. Collective.
    void
    add_to_diagonal(SparseMatrix &matrix, const Vector &terms);

    /// Each element becomes its reciprocal; zero becomes the largest number, for the levels of a
    /// multigrid method may have empty rows.
    void
    invert(Vector &v);

    /// Multiply row i by factors(i).
    void
    scale_rows(SparseMatrix &matrix, const Vector &factors);

    /// Multiply column j by factors(j).
    void
    scale_columns(SparseMatrix &matrix, const Vector &factors);
  } // namespace LA
} // namespace Signorini
