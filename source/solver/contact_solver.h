// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/newton.h"
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  /// Newton's method for one result of the contact search, with the contact law, the linear system
  /// of solids and law, and its linear solver. Replaced when contact is searched for again.
  struct ContactSolver
  {
    /// Keeps references to bodies, contact, hierarchies and timer.
    ContactSolver(const NewtonSettings       &newton_settings,
                  const LinearSolverSettings &linear_settings,
                  const ContactMethod        &method,
                  SolidResidual              &bodies,
                  const GapOperator          &contact,
                  UnconstrainedModes          unconstrained_modes,
                  SolidHierarchy             &hierarchies,
                  dealii::TimerOutput        &timer)
      : law(method.make_law(contact))
      , system(bodies.stiffness(),
               *law,
               std::move(unconstrained_modes),
               bodies.volumetric() ? &bodies.volumetric()->coupling() : nullptr,
               bodies.is_symmetric())
      , linear_solver(linear_settings, system, hierarchies, timer)
      , newton(newton_settings, bodies, *law, system, linear_solver)
    {}

    const std::unique_ptr<ContactLaw> law;
    ContactSystem                     system;
    LinearSolver                      linear_solver;
    Newton                            newton;
  };
} // namespace Signorini
