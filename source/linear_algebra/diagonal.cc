// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/diagonal.h"

#include "linear_algebra/values.h"

#include <Epetra_CrsMatrix.h>
#include <Epetra_Vector.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      // deal.II has no wrapper for the scaling of rows and columns; it changes values only, not the
      // pattern that the wrapper stores.
      Epetra_CrsMatrix &
      epetra(SparseMatrix &matrix)
      {
        return const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix());
      }
    } // namespace



    Vector
    diagonal(const SparseMatrix &matrix)
    {
      Epetra_Vector entries(matrix.trilinos_matrix().RowMap());
      const int     error = matrix.trilinos_matrix().ExtractDiagonalCopy(entries);
      AssertThrow(error == 0, ExcTrilinosError(error));
      Vector result(matrix.locally_owned_range_indices(), matrix.get_mpi_communicator());
      std::copy_n(entries.Values(), entries.MyLength(), values_of(result));
      return result;
    }



    void
    add_to_diagonal(SparseMatrix &matrix, const Vector &terms)
    {
      for (const auto i : terms.locally_owned_elements())
        if (terms(i) > 0)
          matrix.add(i, i, terms(i));
      matrix.compress(VectorOperation::add);
    }



    void
    invert(Vector &v)
    {
      v.trilinos_vector()(0)->Reciprocal(*v.trilinos_vector()(0));
    }



    void
    scale_rows(SparseMatrix &matrix, const Vector &factors)
    {
      const int error = epetra(matrix).LeftScale(*factors.trilinos_vector()(0));
      AssertThrow(error == 0, ExcTrilinosError(error));
    }



    void
    scale_columns(SparseMatrix &matrix, const Vector &factors)
    {
      const int error = epetra(matrix).RightScale(*factors.trilinos_vector()(0));
      AssertThrow(error == 0, ExcTrilinosError(error));
    }
  } // namespace LA
} // namespace Signorini
