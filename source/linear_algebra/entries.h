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

    /// Add to an entry that is there. Throws if it is not.
    /// @param row counts those of this rank
    void
    add_to_entry(SparseMatrix                   &matrix,
                 int                             row,
                 dealii::types::global_dof_index column,
                 double                          value);

    /// K + sum over all ranks of R^T block R, where R takes the elements of a vector at some
    /// indices. Collective. @param indices those of this rank's block; any, of any rank
    SparseMatrix
    sum(const SparseMatrix                                 &K,
        const dealii::FullMatrix<double>                   &block,
        const std::vector<dealii::types::global_dof_index> &indices);

    /// A matrix of given rows, those of this rank, with any columns. Collective.
    SparseMatrix
    matrix_of(
      const std::vector<std::vector<std::pair<dealii::types::global_dof_index, double>>> &rows,
      const dealii::IndexSet &owned_rows,
      const dealii::IndexSet &owned_columns,
      MPI_Comm                comm);

    /// A matrix made row by row from those of another one.
    class RowBuilder
    {
    public:
      /// Refers to `from`. @param rows those of this rank
      RowBuilder(const dealii::IndexSet &rows, const SparseMatrix &from);

      ~RowBuilder();

      /// @param row counts those of this rank
      /// @param columns local ones of the other matrix
      void
      add(int row, int size, const int *columns, const double *values);

      /// Collective, once.
      SparseMatrix
      finish();

    private:
      const SparseMatrix               &from;
      std::unique_ptr<Epetra_CrsMatrix> matrix;
      std::vector<int>                  global; ///< columns of the present row
    };
  } // namespace LA
} // namespace Signorini
