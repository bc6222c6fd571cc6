// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solid/resultant.h"

#include <vector>

namespace Signorini
{
  /// The resultants of supports and loads.
  template <int dim>
  struct Reactions
  {
    /// The resultant of each support, over all bodies.
    std::vector<Resultant<dim>> supports;
    /// The resultant of all loads, over all bodies.
    Resultant<dim> load;
    /// The resultant of all supports and loads on each body.
    std::vector<Resultant<dim>> bodies;
  };

  /// The resultants at the present time of the elasticity. The forces of supports are internal
  /// forces minus loads minus contact forces at constrained degrees of freedom. In axisymmetric
  /// models forces are along the axis only, since radial ones are in equilibrium around the
  /// circumference, and there are no moments. Collective.
  /// @param u displacement of all degrees of freedom
  /// @param contact_force forces of contact on all degrees of freedom, hanging nodes condensed
  template <int dim>
  Reactions<dim>
  reactions(const Elasticity<dim> &elasticity,
            const LA::Vector      &u,
            const LA::Vector      &contact_force);
} // namespace Signorini
