// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"

#include <map>
#include <memory>
#include <vector>

namespace Signorini
{
  /// One solution with what is needed to draw it. Refers to its parts, does not own them.
  template <int dim>
  struct Snapshot
  {
    const Elasticity<dim>                  &elasticity;
    const std::vector<ContactPair<dim>>    &pairs;
    const std::vector<ContactSurface<dim>> &surfaces; ///< pair by pair
    const GapOperator                      &contact;
    const LA::Vector                       &displacement; ///< owned, satisfies its constraints
    /// At the contact points: gap positive when open, pressure positive in compression, active 1 or
    /// 0, or 2 where it changes to and fro, of a load step that was not solved.
    const LA::Vector   &gap, &pressure, &active;
    const ContactState &contact_state;
    double              time;
    unsigned int        step;
    /// By pairs: what recovered_pressure() has found so far. Copies share it.
    std::shared_ptr<std::map<unsigned int, LA::Vector>> recovered =
      std::make_shared<std::map<unsigned int, LA::Vector>>();
  };
} // namespace Signorini
