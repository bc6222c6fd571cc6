// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// The forces of contact on all degrees of freedom, prescribed ones too, hanging nodes condensed.
  /// Collective.
  template <int dim>
  LA::Vector
  contact_force(const Snapshot<dim> &s)
  {
    return s.contact.total_force(s.contact_state.traction,
                                 s.contact.stress(s.displacement,
                                                  s.elasticity.volumetric_stress().coefficients()));
  }
} // namespace Signorini
