// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/laws/contact_state.h"
#include "solver/contact_system.h"
#include "solver/solid_residual.h"

namespace Signorini
{
  /// The l2 norm over all components. Collective.
  double
  norm(const PointVectors &vectors);

  /// True if solutions minimise the energy (4.10) of the displacement: methods without multipliers
  /// with a symmetric system.
  bool
  has_energy(const ContactSystem &system);

  /// The step length a that minimises the energy of u + a du (doc/theory, 4.6), or 1 if the slope
  /// there is at most a tenth of that at the start. Each evaluation costs vectors on the contact
  /// surface only. Collective.
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
    /// The solids; their volumetric stress is that after the full step.
    const SolidResidual &bodies;
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
  /// Newton's method needs this for slender bodies: a linearised rotation also stretches them, with
  /// a stiffness far above that of bending (doc/theory, 4.7; Matthies, Strang, Int. J. Numer. Meth.
  /// Eng. 14 (1979) 1613; Crisfield, ibid. 19 (1983) 1269). An evaluation of the slope costs one
  /// residual, a few percent of a Newton step. Throws SolverFailure where cells are inverted.
  /// Collective.
  /// @param step increment (u, q) or (u, q, m), blocks as of the system
  /// @param longest largest admissible step length
  double
  energy_descending_step(const LineSearchStart &start, const LA::BlockVector &step, double longest);

  /// A step length at which the residual of contact with friction, which has no energy, is smaller
  /// than at the start: 1 if it is so there, else the best of four trials down to a quarter
  /// (doc/theory, 4.6). For linear bodies. With multipliers a trial costs vectors on the contact
  /// surface only, otherwise one residual. Collective.
  /// @param step increment (u, q), blocks as of the system
  double
  residual_reducing_step(const LineSearchStart &start, const LA::BlockVector &step);
} // namespace Signorini
