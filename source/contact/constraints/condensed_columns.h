// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/interface/surface.h"
#include "solid/elasticity.h"

namespace Signorini
{
  /// The degrees of freedom on which those of some columns depend by constraint equations: columns
  /// that B_free needs in addition.
  template <int dim>
  std::vector<dealii::types::global_dof_index>
  columns_by_equations(const Elasticity<dim>                              &elasticity,
                       const std::vector<dealii::types::global_dof_index> &columns);

  /// Supports that are not along the axes tie a component of a node to its others, and constraint
  /// equations to those of other nodes, which move it: what its column has in B (and S), theirs get
  /// in B_free (and S_free). Collective.
  template <int dim>
  void
  add_condensed_columns(const Elasticity<dim> &elasticity, GapOperator &contact);

  /// True if two of the surfaces have contact points at the same positions of a slave face of this
  /// rank. Where one of them carries pressure, the normal stress of the bodies is not that of the
  /// other's constraint, so that the term theta S^T of Nitsche's method would be inconsistent. Not
  /// collective.
  template <int dim>
  bool
  have_coinciding_points(const std::vector<ContactSurface<dim>> &surfaces);
} // namespace Signorini
