// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/hierarchy.h"

#include "linear_algebra/smoothed_aggregation.h"

namespace Signorini
{
  // Spaces first, then aggregates of the coarsest space that has a matrix. Collective.
  Hierarchy::Hierarchy(const Stiffness                        &stiffness,
                       std::vector<Level>                      spaces,
                       const std::vector<std::vector<double>> &modes,
                       const unsigned int                      n_components)
    : fine(stiffness)
    , coarse(std::move(spaces))
    , n_spaces(coarse.size())
    , my_n_components(n_components)
    , coarsest(coarse.empty() ? &stiffness.matrix() : coarse.back().matrix.get())
  {
    for (LA::CoarseLevel &level : LA::smoothed_aggregation(*coarsest, modes, n_components))
      coarse.emplace_back(std::make_unique<AssembledProlongation>(std::move(level.prolongation)),
                          std::move(level.matrix));
    coarsest = coarse.empty() ? &stiffness.matrix() : coarse.back().matrix.get();
  }
} // namespace Signorini
