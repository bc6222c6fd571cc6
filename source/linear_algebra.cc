#include <signorini/linear_algebra.h>

#include <Epetra_CrsMatrix.h>

namespace Signorini
{
  namespace LA
  {
    namespace
    {
      // deal.II wraps no scaling by a diagonal; it changes values only, never the pattern that the
      // wrapper knows.
      Epetra_CrsMatrix &
      epetra(SparseMatrix &matrix)
      {
        return const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix());
      }
    } // namespace



    dealii::IndexSet
    contiguous_partition(const unsigned int n_local, const MPI_Comm comm)
    {
      unsigned int first = 0;
      const int    error = MPI_Exscan(&n_local, &first, 1, MPI_UNSIGNED, MPI_SUM, comm);
      AssertThrowMPI(error);
      if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
        first = 0; // MPI leaves it undefined there
      dealii::IndexSet set(dealii::Utilities::MPI::sum(n_local, comm));
      set.add_range(first, first + n_local);
      return set;
    }



    void
    scale_rows(SparseMatrix &matrix, const Vector &factors)
    {
      const int error = epetra(matrix).LeftScale(*factors.trilinos_vector()(0));
      AssertThrow(error == 0, dealii::ExcTrilinosError(error));
    }



    void
    scale_columns(SparseMatrix &matrix, const Vector &factors)
    {
      const int error = epetra(matrix).RightScale(*factors.trilinos_vector()(0));
      AssertThrow(error == 0, dealii::ExcTrilinosError(error));
    }
  } // namespace LA
} // namespace Signorini
