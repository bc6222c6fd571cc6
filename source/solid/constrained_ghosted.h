// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/displacements.h"

namespace Signorini
{
  /// A copy of a vector with constraints applied, since Newton's method does not update constrained
  /// degrees of freedom, and with ghosts. Collective.
  template <int dim>
  LA::Vector
  constrained_ghosted(const Displacements<dim> &space, LA::Vector u)
  {
    space.distribute(u);
    return space.with_ghosts(u);
  }
} // namespace Signorini
