// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/contact_system.h"

namespace Signorini
{
  /// True if solutions minimise an energy of the displacement: methods without multipliers whose
  /// system is symmetric.
  bool
  has_energy(const ContactSystem &system);

  /// The step length a that minimises the energy of u + a du, or 1 if that is nearly as good. Costs
  /// vectors on the contact surface only. Collective.
  /// @param r residual at u
  /// @param in gap, stress and pressure at u
  double
  energy_minimising_step(const ContactSystem &system,
                         const ContactLaw    &law,
                         const LA::Vector    &r,
                         const LawInputs     &in,
                         const LA::Vector    &du);
} // namespace Signorini
