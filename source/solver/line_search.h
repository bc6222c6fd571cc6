// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/contact_system.h"

namespace Signorini
{
  /// True if solutions are minima of an energy in the displacement: of methods without unknown
  /// pressures, and with a symmetric system.
  bool
  has_energy(const ContactSystem &system);

  /// The a for which u + a du has the least energy, or 1 if that is nearly as good. It costs
  /// vectors of the surface only. Collective.
  /// @param r forces out of balance at u
  /// @param in gap, stress and pressure at u
  double
  energy_minimising_step(const ContactSystem &system,
                         const ContactLaw    &law,
                         const LA::Vector    &r,
                         const LawInputs     &in,
                         const LA::Vector    &du);
} // namespace Signorini
