// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <Eigen/SparseLU>

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
  } // namespace LA
} // namespace Signorini
