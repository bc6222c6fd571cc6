// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// @return the vertices of a cell where stresses of the exact solution have no limit: at the ends
  /// of supports that hold the body along its surface, beside a free surface, and at re-entrant
  /// corners and edges with plane faces that turn by about 60 degrees or more (for equal faces).
  /// Ends of contact and of ties are not among them.
  /// @param elasticity the model
  /// @param cell locally owned
  template <int dim>
  std::vector<dealii::Point<dim>>
  singular_vertices(const Elasticity<dim>                                        &elasticity,
                    const typename dealii::DoFHandler<dim>::active_cell_iterator &cell);
} // namespace Signorini
