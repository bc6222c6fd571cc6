// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/contact_rows.h"
#include "contact/constraints/gap_operator.h"

namespace Signorini
{
  /// Assemble how the normal stress at the contact points depends on fields beside the
  /// displacement, once the points' areas are known: GapOperator::S_thermal on the rises of the
  /// temperature, nothing if no body expands; S_volumetric on the volumetric stress, nothing if no
  /// body is mixed; fixed_stress, which depends on none.
  template <int dim>
  void
  assemble_field_stress(const Elasticity<dim>                  &elasticity,
                        const ContactRows                      &rows,
                        const std::vector<ContactSurface<dim>> &surfaces,
                        GapOperator                            &contact);
} // namespace Signorini
