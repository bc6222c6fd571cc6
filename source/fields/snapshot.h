// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"

#include <map>
#include <memory>
#include <vector>

namespace Signorini
{
  /// One solution with all objects that are needed to evaluate it, to which it refers without
  /// owning them.
  template <int dim>
  struct Snapshot
  {
    const Elasticity<dim>               &elasticity;
    const std::vector<ContactPair<dim>> &pairs;
    /// One for each pair.
    const std::vector<ContactSurface<dim>> &surfaces;
    const GapOperator                      &contact;
    /// Without ghost values; satisfies its constraints.
    const LA::Vector &displacement;
    /// At the contact points: gap [length], positive when open; pressure [stress], positive in
    /// compression; active 1 or 0, or 2 where it alternates in a load step that was not solved.
    const LA::Vector   &gap, &pressure, &active;
    const ContactState &contact_state;
    /// Of each pair, see State; may be empty.
    const std::vector<double> &friction_work;
    /// The bound of friction of each pair at the start of the load step, see State; empty: unknown.
    const std::vector<double> &friction_bound_at_start;
    double                     time;
    unsigned int               step;
    /// Number of equal parts in which load steps were solved.
    unsigned int parts = 1;
    /// Results of recovered_pressure() by pair. Copies share them.
    std::shared_ptr<std::map<unsigned int, LA::Vector>> recovered =
      std::make_shared<std::map<unsigned int, LA::Vector>>();
  };
} // namespace Signorini
