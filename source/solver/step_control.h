// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"
#include "solver/contact_system.h"
#include "solver/solid_residual.h"

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

  /// The iterate at which a line search starts; refers to all.
  struct LineSearchStart
  {
    const SolidResidual &bodies; ///< their volumetric stress is that which the step leads to
    const ContactSystem &system;
    const ContactLaw    &law;
    const LA::Vector    &u;
    const ContactState  &contact;
    const LA::Vector    &r; ///< residual at u
  };

  /// A step length a up to `longest` at which the energy of u + a du is about minimal; or `longest`
  /// if the energy decreases all along the step, or hardly increases at its end. Where contact
  /// pressures are unknowns, the energy is that of the augmented Lagrangian with the multipliers p
  /// + a dp and the penalty by which the active set is decided; bodies in displacement-pressure
  /// form have the volumetric stress that the step leads to; and where forces have no potential,
  /// their work along the step takes the place of the energy.
  ///
  /// Newton's method needs this for slender bodies: a linearised rotation also stretches, with far
  /// more stiffness than bending has. A slope costs one residual, some percent of a step. Matthies,
  /// Strang, Int. J. Numer. Meth. Eng. 14 (1979) 1613; Crisfield, ibid. 19 (1983) 1269. Throws
  /// SolverFailure where cells are inverted. Collective.
  /// @param step (u, q) or (u, q, m) as of the system
  double
  energy_descending_step(const LineSearchStart &start, const LA::BlockVector &step, double longest);
} // namespace Signorini
