// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <memory>
#include <vector>

class Epetra_Import;
class Epetra_Vector;

namespace Signorini
{
  namespace LA
  {
    /// The global index of each local column: of those that the rows of this rank refer to.
    std::vector<dealii::types::global_dof_index>
    global_columns(const SparseMatrix &matrix);

    /// Between a vector that a matrix can be applied to and its elements at the matrix's local
    /// columns, some of which other ranks own. Refers to the matrix, whose entries must stay where
    /// they are. All but size() is collective.
    class ColumnExchange
    {
    public:
      explicit ColumnExchange(const SparseMatrix &matrix);

      ~ColumnExchange();

      /// Number of local columns.
      unsigned int
      size() const;

      /// @param values gets the elements of v by local column
      void
      fetch(const Vector &v, double *values) const;

      /// The same in a new array.
      std::vector<double>
      fetch(const Vector &v) const;

      /// Add values, by local column on each rank, to the elements of v.
      void
      add(const double *values, Vector &v) const;

      /// Elements of v become the largest absolute value among theirs and those given.
      void
      enlarge(const double *values, Vector &v) const;

    private:
      std::unique_ptr<Epetra_Import> own; ///< where the matrix has none
      const Epetra_Import           &columns;
      std::unique_ptr<Epetra_Vector> buffer;
    };
  } // namespace LA
} // namespace Signorini
