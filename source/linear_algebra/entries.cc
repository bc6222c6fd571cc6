// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/entries.h"

#include "linear_algebra/row_view.h"

#include <Epetra_CrsMatrix.h>
#include <Epetra_FECrsMatrix.h>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    std::size_t
    memory_consumption(const SparseMatrix &matrix)
    {
      return matrix.trilinos_matrix().NumMyNonzeros() * (sizeof(double) + sizeof(int));
    }



    void
    add_to_entry(SparseMatrix                 &matrix,
                 const int                     row,
                 const types::global_dof_index column,
                 const double                  value)
    {
      // Only a value changes, not the pattern that the wrapper stores.
      auto     &entries = const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix());
      const int local   = entries.ColMap().LID(static_cast<int>(column));
      const int error   = entries.SumIntoMyValues(row, 1, &value, &local);
      AssertThrow(error == 0, ExcTrilinosError(error));
    }



    // Both summands are inserted into a new matrix; entries of rows of other ranks are sent to
    // their owners by GlobalAssemble.
    SparseMatrix
    sum(const SparseMatrix                         &K,
        const FullMatrix<double>                   &block,
        const std::vector<types::global_dof_index> &indices)
    {
      const Epetra_CrsMatrix &first = K.trilinos_matrix();
      Epetra_FECrsMatrix      sum(Copy, first.RowMap(), 0);
      const int              *global = first.ColMap().MyGlobalElements();
      std::vector<int>        columns;
      std::vector<double>     values;
      for (int i = 0; i < first.NumMyRows(); ++i)
        {
          const RowView row(K, i);
          columns.clear();
          for (int k = 0; k < row.size; ++k)
            columns.push_back(global[row.columns[k]]);
          sum.InsertGlobalValues(first.GRID(i), row.size, row.values, columns.data());
        }
      for (unsigned int i = 0; i < block.m(); ++i)
        {
          columns.clear();
          values.clear();
          for (unsigned int j = 0; j < block.n(); ++j)
            if (block(i, j) != 0)
              {
                columns.push_back(indices[j]);
                values.push_back(block(i, j));
              }
          if (columns.empty())
            continue;
          const int row = indices[i];
          sum.InsertGlobalValues(1, &row, columns.size(), columns.data(), values.data());
        }
      const int error = sum.GlobalAssemble(first.DomainMap(), first.RangeMap());
      AssertThrow(error == 0, ExcTrilinosError(error));
      SparseMatrix result;
      result.reinit(static_cast<const Epetra_CrsMatrix &>(sum));
      return result;
    }



    // FillComplete() makes the column map from the columns that occur. Collective.
    SparseMatrix
    matrix_of(const std::vector<std::vector<std::pair<types::global_dof_index, double>>> &rows,
              const IndexSet &owned_rows,
              const IndexSet &owned_columns,
              const MPI_Comm  comm)
    {
      const Epetra_Map map    = owned_rows.make_trilinos_map(comm),
                       domain = owned_columns.make_trilinos_map(comm);
      std::vector<int> sizes;
      for (const auto &row : rows)
        sizes.push_back(row.size());
      Epetra_CrsMatrix    matrix(Copy, map, sizes.data());
      std::vector<int>    columns;
      std::vector<double> values;
      for (unsigned int i = 0; i < rows.size(); ++i)
        {
          columns.clear();
          values.clear();
          for (const auto &[j, value] : rows[i])
            {
              columns.push_back(j);
              values.push_back(value);
            }
          const int error = matrix.InsertGlobalValues(matrix.GRID(i),
                                                      columns.size(),
                                                      values.data(),
                                                      columns.data());
          AssertThrow(error >= 0, ExcTrilinosError(error));
        }
      const int error = matrix.FillComplete(domain, map);
      AssertThrow(error == 0, ExcTrilinosError(error));
      SparseMatrix result;
      result.reinit(matrix);
      return result;
    }



    // Rows are copied with the global columns of `from`, whose distribution of columns the result
    // has.
    RowBuilder::RowBuilder(const IndexSet &rows, const SparseMatrix &from)
      : from(from)
      , matrix(std::make_unique<Epetra_CrsMatrix>(
          Copy, rows.make_trilinos_map(from.get_mpi_communicator()), 0))
    {}



    RowBuilder::~RowBuilder() = default;



    void
    RowBuilder::add(const int row, const int size, const int *columns, const double *values)
    {
      global.resize(size);
      for (int k = 0; k < size; ++k)
        global[k] = from.trilinos_matrix().GCID(columns[k]);
      const int error = matrix->InsertGlobalValues(matrix->GRID(row), size, values, global.data());
      AssertThrow(error >= 0, ExcTrilinosError(error)); // positive: it has taken more memory
    }



    SparseMatrix
    RowBuilder::finish()
    {
      const int error = matrix->FillComplete(from.trilinos_matrix().DomainMap(), matrix->RowMap());
      AssertThrow(error == 0, ExcTrilinosError(error));
      SparseMatrix result;
      result.reinit(*matrix);
      return result;
    }
  } // namespace LA
} // namespace Signorini
