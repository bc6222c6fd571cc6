// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/types.h"

namespace Signorini
{
  namespace LA
  {
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
  } // namespace LA
} // namespace Signorini
