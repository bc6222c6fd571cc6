// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace Signorini
{
  namespace LA
  {
    /// A row of this rank without the detour over iterators, which cost a hundred times more. Its
    /// entries belong to the matrix.
    struct RowView
    {
      /// @param row counts those of this rank
      RowView(const SparseMatrix &matrix, const int row)
      {
        const int error = matrix.trilinos_matrix().ExtractMyRowView(row, size, values, columns);
        AssertThrow(error == 0, dealii::ExcTrilinosError(error));
      }

      /// Points between the same two faces have the same columns.
      bool
      has_columns_of(const RowView &other) const
      {
        return size == other.size && std::equal(columns, columns + size, other.columns);
      }

      int     size;
      double *values;
      int    *columns; ///< local, see global_columns()
    };
  } // namespace LA
} // namespace Signorini
