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
    /// The global index of each local column, that is, of each column that the rows of this rank
    /// refer to.
    std::vector<dealii::types::global_dof_index>
    global_columns(const SparseMatrix &matrix);

    /// Exchange between a distributed vector to which a matrix can be applied and its elements at
    /// the matrix's local columns, some of which belong to other ranks. Refers to the matrix, whose
    /// pattern must not change. All functions but size() are collective.
    class ColumnExchange
    {
    public:
      explicit ColumnExchange(const SparseMatrix &matrix);

      ~ColumnExchange();

      /// Number of local columns.
      unsigned int
      size() const;

      /// @param v vector without ghosts
      /// @param values set to the elements of v by local column; size() entries
      void
      fetch(const Vector &v, double *values) const;

      /// The elements of v by local column, in a new array.
      std::vector<double>
      fetch(const Vector &v) const;

      /// Add values, by local column on each rank, to the elements of v.
      void
      add(const double *values, Vector &v) const;

      /// Elements of v become the largest absolute value among those given, by any rank.
      /// @param v in: zero
      void
      enlarge(const double *values, Vector &v) const;

    private:
      std::unique_ptr<Epetra_Import> own; ///< where the matrix has none
      const Epetra_Import           &columns;
      std::unique_ptr<Epetra_Vector> buffer;
    };
  } // namespace LA
} // namespace Signorini
