// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/error_history.h"
#include "accuracy/error_parts.h"
#include "accuracy/quantity.h"
#include "solver/dual_solution.h"

#include <vector>

namespace Signorini
{
  /// The estimated errors of a solution on one mesh.
  struct ErrorEstimate
  {
    /// Energy norm of the error, relative to that of the solution.
    double energy = 0;
    /// One entry for each quantity.
    std::vector<QuantityEstimate> quantities;
    /// The contributions of all cells.
    CellErrors cells;
    /// Iterations of the linear solver for all dual solutions.
    unsigned int iterations = 0;
  };

  /// Estimate the errors of a solution (doc/theory, chapter 8). Collective.
  /// @param snapshot the solution
  /// @param functionals the quantities with their derivatives
  /// @param duals their dual solutions
  /// @param is_consistent whether the contact method closes gaps as the mesh is refined, whatever
  /// its parameter; then there is no error of enforcement
  /// @param path errors of the quantities by the length of load steps; empty: none
  /// @param neglected relative error by contact in the reference configuration, (5.21), and by
  /// small strain, (6.21)
  /// @return errors of the cells and of all quantities
  template <int dim>
  ErrorEstimate
  error_estimate(const Snapshot<dim>             &snapshot,
                 const std::vector<Functional>   &functionals,
                 const std::vector<DualSolution> &duals,
                 bool                             is_consistent,
                 const std::vector<double>       &path,
                 double                           neglected);
} // namespace Signorini
