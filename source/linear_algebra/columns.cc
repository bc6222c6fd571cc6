// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/columns.h"

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      /// An importer for matrices that have none, because all their columns are local: it then only
      /// copies. Null if the matrix has one.
      std::unique_ptr<Epetra_Import>
      make_missing_importer(const Epetra_CrsMatrix &matrix)
      {
        return matrix.Importer() ?
                 nullptr :
                 std::make_unique<Epetra_Import>(matrix.ColMap(), matrix.DomainMap());
      }

      /// Combine values at the local columns with the elements of the owners by the given mode.
      /// Collective.
      void
      send(Epetra_Vector           &from,
           const double            *values,
           const Epetra_Import     &columns,
           const Epetra_CombineMode mode,
           Vector                  &to)
      {
        std::copy_n(values, from.MyLength(), from.Values());
        Epetra_MultiVector &owned = to.trilinos_vector();
        const int           error = owned.Export(from, columns, mode);
        AssertThrow(error == 0, ExcTrilinosError(error));
      }
    } // namespace



    std::vector<types::global_dof_index>
    global_columns(const SparseMatrix &matrix)
    {
      const Epetra_Map                    &map = matrix.trilinos_matrix().ColMap();
      std::vector<types::global_dof_index> result(map.NumMyElements());
      for (unsigned int k = 0; k < result.size(); ++k)
        result[k] = map.GID64(k);
      return result;
    }



    ColumnExchange::ColumnExchange(const SparseMatrix &matrix)
      : own(make_missing_importer(matrix.trilinos_matrix()))
      , columns(own ? *own : *matrix.trilinos_matrix().Importer())
      , buffer(std::make_unique<Epetra_Vector>(matrix.trilinos_matrix().ColMap()))
    {}



    ColumnExchange::~ColumnExchange() = default;



    unsigned int
    ColumnExchange::size() const
    {
      return buffer->MyLength();
    }



    void
    ColumnExchange::fetch(const Vector &v, double *values) const
    {
      const int error = buffer->Import(v.trilinos_vector(), columns, Insert);
      AssertThrow(error == 0, ExcTrilinosError(error));
      std::copy_n(buffer->Values(), buffer->MyLength(), values);
    }



    std::vector<double>
    ColumnExchange::fetch(const Vector &v) const
    {
      std::vector<double> values(size());
      fetch(v, values.data());
      return values;
    }



    void
    ColumnExchange::add(const double *values, Vector &v) const
    {
      // Plain Add would overwrite the elements that this rank owns itself.
      send(*buffer, values, columns, Epetra_AddLocalAlso, v);
    }



    void
    ColumnExchange::enlarge(const double *values, Vector &v) const
    {
      send(*buffer, values, columns, AbsMax, v);
    }
  } // namespace LA
} // namespace Signorini
