// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "linear_algebra/types.h"

#include <vector>

namespace Signorini
{
  /// Elements of a vector, which may be on other ranks.
  class VectorValues
  {
  public:
    /// Collective. @param u without ghosts @param indices in any order, repeated or not
    VectorValues(const LA::Vector &u, std::vector<dealii::types::global_dof_index> indices);

    /// Of one of the indices.
    double
    operator()(dealii::types::global_dof_index index) const;

    /// row . u
    double
    operator()(const SparseRow &row) const;

  private:
    std::vector<dealii::types::global_dof_index> indices; ///< sorted
    std::vector<double>                          values;
  };

  /// By which the gap of each point opens: row() . u. Collective.
  /// @param u without ghosts
  template <int dim>
  std::vector<double>
  gap_increments(const std::vector<const ContactPoint<dim> *> &points, const LA::Vector &u);
} // namespace Signorini
