// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/newton.h"
#include <signorini/contact/methods/method.h>

namespace Signorini
{
  /// All that Newton's method needs for contact as it was found: the law, the linear system of
  /// bodies and law, its solver. Goes when contact is looked for again.
  struct ContactSolver
  {
    /// Refers to bodies, contact, hierarchies and timer.
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
