// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"
#include <signorini/linear_algebra/direct_library.h>

#include <memory>
#include <vector>

#include <Eigen/SparseLU>

class Amesos_BaseSolver;
class Epetra_LinearProblem;

namespace Signorini
{
  namespace LA
  {
    /// Sparse LU factorisation of a matrix of one rank, for saddle points: unknowns with small
    /// diagonal entries, such as multipliers, are each ordered behind an unknown that they are
    /// coupled to, whose elimination makes their pivot large. So the order that keeps the factors
    /// sparse, approximate minimum degree, need not be changed by pivoting. (Schenk, Gaertner,
    /// Electron. Trans. Numer. Anal. 23 (2006) 158-179, compress unknowns for their order in this
    /// way.)
    class OrderedLU
    {
    public:
      /// @return whether the matrix was factorised; it may be singular
      bool
      factorise(const SparseMatrix &matrix);

      void
      solve(Vector &x, const Vector &right) const;

    private:
      using Matrix = Eigen::SparseMatrix<double>;

      std::vector<int>                                     place; ///< of each unknown in the order
      Eigen::SparseLU<Matrix, Eigen::NaturalOrdering<int>> factors;
      mutable Eigen::VectorXd                              ordered;
    };

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
