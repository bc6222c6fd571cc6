// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/constraints/tangents.h"

namespace Signorini
{
  /// Remove the slip across planes of symmetry from the rows of slave nodes on them, where supports
  /// hold the slave and the master there in the same direction. There is none between the surfaces,
  /// and no traction in that direction, by symmetry. But of a multiplier at such a node, whose own
  /// motion is prescribed, only the motion of master nodes beside the plane would be left in the
  /// weighted slip, which would hold these. Collective.
  /// @param tangents of the rows
  /// @param contact with B, rows of the slip and offsets; changed
  template <int dim>
  void
  remove_slip_across_symmetry_planes(const Elasticity<dim> &elasticity,
                                     const Tangents<dim>   &tangents,
                                     GapOperator           &contact);
} // namespace Signorini
