// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// @return the contact forces on all degrees of freedom, (3.5) of doc/theory, also on prescribed
  /// ones, with hanging nodes condensed. Collective.
  /// @param s the solution
  template <int dim>
  LA::Vector
  contact_force(const Snapshot<dim> &s)
  {
    return s.contact.total_force(s.contact_state.traction,
                                 s.contact.stress(s.displacement,
                                                  s.elasticity.volumetric_stress().coefficients()));
  }
} // namespace Signorini
