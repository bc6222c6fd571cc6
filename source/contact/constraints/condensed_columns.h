// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "solid/elasticity.h"

namespace Signorini
{
  /// Supports that are not along the axes tie a component of a node to its others, which move it:
  /// what its column has in B (and S), theirs get in B_free (and S_free). Collective.
  template <int dim>
  void
  add_condensed_columns(const Elasticity<dim> &elasticity, GapOperator &contact);
} // namespace Signorini
