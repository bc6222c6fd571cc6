// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/displacements.h"

namespace Signorini
{
  /// With the values of constrained degrees of freedom, which Newton's method leaves alone, and
  /// ghosts. Collective.
  template <int dim>
  LA::Vector
  constrained_ghosted(const Displacements<dim> &space, LA::Vector u)
  {
    space.distribute(u);
    return space.with_ghosts(u);
  }
} // namespace Signorini
