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
    std::vector<Resultant<dim>> supports; ///< each on all bodies
    Resultant<dim>              load;     ///< on all bodies
    std::vector<Resultant<dim>> bodies;   ///< all supports and loads on each body
  };

  /// At the present time of the elasticity. Supports exert internal forces minus loads minus
  /// contact forces at the degrees of freedom of each. Axisymmetric: along the axis alone, as the
  /// circumference is in balance, and no moments. Collective.
  /// @param u displacement of all degrees of freedom
  /// @param contact_force forces of contact on all degrees of freedom, hanging nodes condensed
  template <int dim>
  Reactions<dim>
  reactions(const Elasticity<dim> &elasticity,
            const LA::Vector      &u,
            const LA::Vector      &contact_force);
} // namespace Signorini
