// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/solver_failure.h"

#include <deal.II/base/mpi.h>

#include <string>

namespace Signorini
{
  /// Throws SolverFailure on all ranks if cells are inverted on one of them. Collective.
  inline void
  check_folds(const std::string &body_here, const MPI_Comm comm)
  {
    for (const std::string &body : dealii::Utilities::MPI::all_gather(comm, body_here))
      if (!body.empty())
        throw SolverFailure("cells of " + body + " would be inverted; use smaller load steps");
  }
} // namespace Signorini
