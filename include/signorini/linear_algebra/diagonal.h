#pragma once

#include <signorini/linear_algebra/types.h>

namespace Signorini
{
  namespace LA
  {
    /// Of a square matrix.
    Vector
    diagonal(const SparseMatrix &matrix);

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
