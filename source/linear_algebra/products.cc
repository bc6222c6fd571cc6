// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/products.h"

#include <EpetraExt_MatrixMatrix.h>
#include <Epetra_CrsMatrix.h>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    void
    multiply(const SparseMatrix &A, Vector &dst, const Vector &src)
    {
      const int error =
        A.trilinos_matrix().Multiply(false, src.trilinos_vector(), dst.trilinos_vector());
      AssertThrow(error == 0, ExcTrilinosError(error));
    }



    SparseMatrix
    product(const SparseMatrix &A, const SparseMatrix &B)
    {
      const Epetra_CrsMatrix &a = A.trilinos_matrix();
      Epetra_CrsMatrix        c(Copy, a.RowMap(), 0);
      const int error = EpetraExt::MatrixMatrix::Multiply(a, false, B.trilinos_matrix(), false, c);
      AssertThrow(error == 0, ExcTrilinosError(error));
      SparseMatrix result;
      result.reinit(c);
      return result;
    }
  } // namespace LA
} // namespace Signorini
