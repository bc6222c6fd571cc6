// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

class Epetra_CrsMatrix;

namespace Signorini
{
  namespace LA
  {
    /// Bytes of the entries on this rank.
    std::size_t
    memory_consumption(const SparseMatrix &matrix);

    /// Add to an existing entry. Throws if it does not exist.
    /// @param row local number of the row
    void
    add_to_entry(SparseMatrix                   &matrix,
                 int                             row,
                 dealii::types::global_dof_index column,
                 double                          value);

    /// The matrix K + sum over all ranks of R^T block R, where R selects the elements of a vector
    /// with some indices. Collective.
    /// @param block dense matrix of this rank
    /// @param indices indices of the block's rows and columns, owned by any rank
    SparseMatrix
    sum(const SparseMatrix                                 &K,
        const dealii::FullMatrix<double>                   &block,
        const std::vector<dealii::types::global_dof_index> &indices);

    /// A matrix from the rows of this rank, whose columns may be any. Collective.
    SparseMatrix
    matrix_of(
      const std::vector<std::vector<std::pair<dealii::types::global_dof_index, double>>> &rows,
      const dealii::IndexSet &owned_rows,
      const dealii::IndexSet &owned_columns,
      MPI_Comm                comm);

    /// Builds a matrix row by row, with the columns of another matrix.
    class RowBuilder
    {
    public:
      /// Refers to `from`. @param rows those of this rank
      RowBuilder(const dealii::IndexSet &rows, const SparseMatrix &from);

      ~RowBuilder();

      /// Add entries to a row.
      /// @param row local number of the row in the new matrix
      /// @param size number of entries
      /// @param columns local columns of the other matrix
      /// @param values entries
      void
      add(int row, int size, const int *columns, const double *values);

      /// The matrix; to be called once. Collective.
      SparseMatrix
      finish();

    private:
      const SparseMatrix               &from;
      std::unique_ptr<Epetra_CrsMatrix> matrix;
      std::vector<int>                  global; ///< columns of the present row
    };
  } // namespace LA
} // namespace Signorini
