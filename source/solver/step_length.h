// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"
#include "solver/contact_system.h"
#include "solver/solid_residual.h"

namespace Signorini
{
  /// Where a step starts; refers to all.
  struct LineSearchStart
  {
    const SolidResidual &bodies; ///< their volumetric stress is that which the step leads to
    const ContactSystem &system;
    const ContactLaw    &law;
    const LA::Vector    &u;
    const ContactState  &contact;
    const LA::Vector    &r; ///< forces out of balance
  };

  /// An a up to the longest for which u + a du has about the least energy, or the longest if the
  /// energy falls all the way, or hardly rises at its end. Where contact pressures are unknowns,
  /// it is that of the augmented Lagrangian, with the multipliers that go along, p + a dp, and
  /// the stiffness by which the active set is decided; mixed bodies have the volumetric stress that
  /// the step leads to; and where forces have no energy, it is the work that is done against them.
  ///
  /// Of slender bodies Newton's method leads far off otherwise: what turns stretches as well, with
  /// far more stiffness than bending has. A slope costs a residual, some percent of a step.
  /// Matthies, Strang, Int. J. Numer. Meth. Eng. 14 (1979) 1613; Crisfield, ibid. 19 (1983) 1269.
  /// Throws SolverFailure where cells are folded. Collective.
  /// @param step (u, q) or (u, q, m) as of the system
  double
  energy_descending_step(const LineSearchStart &start, const LA::BlockVector &step, double longest);
} // namespace Signorini
