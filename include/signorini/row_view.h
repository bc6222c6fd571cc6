#pragma once

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace Signorini
{
  /// Local row of a matrix without the detour over iterators, which cost a hundred times more.
  struct RowView
  {
    RowView(const Epetra_CrsMatrix &matrix, const int row)
    {
      const int error = matrix.ExtractMyRowView(row, size, values, columns);
      AssertThrow(error == 0, dealii::ExcTrilinosError(error));
    }

    RowView(const dealii::TrilinosWrappers::SparseMatrix &matrix, const int row)
      : RowView(matrix.trilinos_matrix(), row)
    {}

    /// Points between the same two faces have the same columns.
    bool
    has_columns_of(const RowView &other) const
    {
      return size == other.size && std::equal(columns, columns + size, other.columns);
    }

    int     size;
    double *values;
    int    *columns; ///< local
  };
} // namespace Signorini
