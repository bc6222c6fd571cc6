// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/ordered_lu.h"
#include <signorini/linear_algebra/direct_library.h>

#include <memory>

class Amesos_BaseSolver;
class Epetra_LinearProblem;

namespace Signorini
{
  namespace LA
  {
    /// A sparse LU factorisation, by Eigen or one of the libraries that Trilinos may have been
    /// built with.
    class DirectSolver
    {
    public:
      explicit DirectSolver(DirectLibrary library);

      ~DirectSolver();

      /// True if the library is there: Trilinos may have been built without it.
      static bool
      is_available(DirectLibrary library);

      /// Factorise a matrix, which is referred to until clear() or the next call. Collective.
      /// @return zero, or the library's error code if the matrix is singular or memory does not
      /// suffice
      [[nodiscard]] int
      factorise(const SparseMatrix &matrix);

      /// Release the factors and the reference to the matrix.
      void
      clear();

      /// Solve with the matrix factorised last. Throws dealii::ExcTrilinosError. Collective.
      void
      solve(Vector &x, const Vector &right) const;

    private:
      const DirectLibrary                   library;
      std::unique_ptr<Epetra_LinearProblem> problem;
      /// Refers to `problem`, which must be destroyed after it.
      std::unique_ptr<Amesos_BaseSolver> solver;
      std::unique_ptr<OrderedLU>         ordered; ///< instead of both
    };
  } // namespace LA
} // namespace Signorini
