// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Signorini
{
  /// The types of linear algebra. Epetra is being removed from Trilinos; its successor (Tpetra,
  /// from deal.II 9.7 on) is to be introduced here and in the other files of this folder, since no
  /// file outside of it names a type of Epetra, ML or Amesos.
  namespace LA
  {
    using Vector       = dealii::TrilinosWrappers::MPI::Vector;
    using BlockVector  = dealii::TrilinosWrappers::MPI::BlockVector;
    using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;

    /// The partition of 0, 1, 2, … in which each rank in turn owns n_local indices. Collective.
    dealii::IndexSet
    contiguous_partition(unsigned int n_local, MPI_Comm comm);
  } // namespace LA
} // namespace Signorini
