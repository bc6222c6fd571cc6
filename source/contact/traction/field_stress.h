// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"

namespace Signorini
{
  /// Assemble the dependence of the normal stress at the contact points on fields other than the
  /// displacement: GapOperator::S_thermal on temperature changes (empty if no body expands),
  /// S_volumetric on the volumetric stress (empty if no body is in displacement-pressure form), and
  /// the constant part fixed_stress. The areas of the points must be set before.
  template <int dim>
  void
  assemble_field_stress(const Elasticity<dim>                  &elasticity,
                        const ContactRows                      &rows,
                        const std::vector<ContactSurface<dim>> &surfaces,
                        GapOperator                            &contact);
} // namespace Signorini
