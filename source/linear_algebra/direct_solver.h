// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"
#include <signorini/linear_algebra/direct_library.h>

#include <memory>

class Amesos_BaseSolver;
class Epetra_LinearProblem;

namespace Signorini
{
  namespace LA
  {
    /// A sparse LU factorisation, by one of the libraries that Trilinos may have been built with.
    class DirectSolver
    {
    public:
      explicit DirectSolver(DirectLibrary library);

      ~DirectSolver();

      static bool
      is_available(DirectLibrary library);

      /// Refers to the matrix until clear() or the next one. Returns zero, or the library's error
      /// if the matrix is singular or memory does not suffice. Collective.
      [[nodiscard]] int
      factorise(const SparseMatrix &matrix);

      /// Forget the factors and the matrix, which may go then.
      void
      clear();

      /// Solve with the matrix factorised last. Collective. Throws dealii::ExcTrilinosError.
      void
      solve(Vector &x, const Vector &right) const;

    private:
      const DirectLibrary                   library;
      std::unique_ptr<Epetra_LinearProblem> problem;
      std::unique_ptr<Amesos_BaseSolver>    solver; ///< looks at problem until it is gone
    };
  } // namespace LA
} // namespace Signorini
