#pragma once

#include <signorini/elasticity/elasticity.h>

#include <functional>

namespace Signorini
{
  /// What the diagonal of C^T K C has beyond that of K because degrees of freedom hang on others
  /// (hanging nodes, inclined supports): with the weights c_rj of constraint r,
  ///   sum over cells of sum_rs c_rj c_sj K_rs - K_jj.
  /// @param add takes degree of freedom j and a summand; j may be another rank's
  template <int dim>
  void
  add_tied_diagonal(const Elasticity<dim>                                              &elasticity,
                    const std::function<void(dealii::types::global_dof_index, double)> &add);
} // namespace Signorini
