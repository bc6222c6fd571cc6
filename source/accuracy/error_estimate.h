// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/cell_errors.h"
#include "accuracy/error_history.h"
#include "accuracy/quantity.h"
#include "solver/dual_solution.h"

#include <vector>

namespace Signorini
{
  /// The estimated errors of a solution.
  struct ErrorEstimate
  {
    double                        energy = 0; ///< of the error, relative to the solution: norm
    std::vector<QuantityEstimate> quantities;
    CellErrors                    cells;
    unsigned int                  iterations = 0; ///< of the dual solutions
  };

  /// @param functionals and their dual solutions, one a quantity
  /// @param is_consistent the method closes gaps as the mesh gets finer, whatever its parameter
  /// @param neglected share of the pressure by which contact on surfaces at rest is wrong
  /// Collective.
  template <int dim>
  ErrorEstimate
  error_estimate(const Snapshot<dim>             &snapshot,
                 const std::vector<Functional>   &functionals,
                 const std::vector<DualSolution> &duals,
                 bool                             is_consistent,
                 double                           neglected);
} // namespace Signorini
