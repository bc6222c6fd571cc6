#pragma once

#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Signorini
{
  /// The one place that knows which linear algebra is used. Epetra is leaving Trilinos; what comes
  /// after it (Tpetra, from deal.II 9.7 on) has the same interface and is exchanged here.
  namespace LA
  {
    using Vector       = dealii::TrilinosWrappers::MPI::Vector;
    using BlockVector  = dealii::TrilinosWrappers::MPI::BlockVector;
    using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;

    /// The partition of 0, 1, 2, … in which each rank in turn owns n_local indices.
    dealii::IndexSet
    contiguous_partition(unsigned int n_local, MPI_Comm comm);

    /// Multiply row i by factors(i).
    void
    scale_rows(SparseMatrix &matrix, const Vector &factors);

    /// Multiply column j by factors(j).
    void
    scale_columns(SparseMatrix &matrix, const Vector &factors);
  } // namespace LA
} // namespace Signorini
