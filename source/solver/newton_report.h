// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <deal.II/base/conditional_ostream.h>

#include <functional>
#include <string>
#include <vector>

namespace Signorini
{
  /// One step of Newton's method, for reports and output.
  struct NewtonStep
  {
    /// Number of active points, of changes of the active set, and of those that open or close a
    /// point; iterations of the Krylov method (0: none was needed; 1: exact preconditioner).
    unsigned int active = 0, changes = 0, contact_changes = 0, krylov_iterations = 0;
    /// Residual of forces and of gaps, relative to the scales of ConvergenceCriteria, before the
    /// step; and the step length of the step before.
    double residual = 0, gap_residual = 0, damping = 1;
    double residual_of_bodies =
      0; ///< the largest one of a body, relative, see ConvergenceCriteria::reference_forces()
    bool kept_previous_set = false; ///< the active set is that of the last load step
    bool restricted_set =
      false;                ///< overlapping points are not active yet, see restrict_to_deepest()
    bool augmented = false; ///< converged, and starts the next augmentation
    /// Iterative solver failed: the system is factorised from this step on.
    bool fell_back_to_direct = false;
  };

  /// The result of a solution with Newton's method.
  struct NewtonReport
  {
    bool                    converged = false;
    std::string             reason; ///< if not converged
    std::vector<NewtonStep> steps;
    /// Rigid-body modes that neither supports nor contact constrain: they are stabilised by forces
    /// of at most `stabilisation_force`.
    std::vector<std::string> undetermined_modes;
    double                   stabilisation_force = 0;
    bool       has_unconstrained_modes = false; ///< unconstrained modes are why it did not converge
    LA::Vector chattering; ///< if not converged: 1 at contact points whose status oscillates
    /// The tangent at the solution, or at the last iterate, was found to be indefinite, so that it
    /// may be unstable, see Newton::tangent_is_indefinite(). False if that was not checked.
    bool tangent_is_indefinite = false;
    /// The displacement rate divided by that of the load step before, if it is more than 3 and the
    /// tangent is indefinite somewhere on the straight line between the two solutions: a sign of
    /// snap-through. Else 0.
    double speed_ratio = 0;
    /// See Newton::friction_over_critical().
    double friction_over_critical = 0;
    /// Body with the largest relative residual, if not converged.
    unsigned int worst_body = dealii::numbers::invalid_unsigned_int;

    /// True if the iteration has ended, with or without success.
    bool
    is_finished() const
    {
      return converged || !reason.empty();
    }
  };

  /// Called after each Newton step.
  using StepVisitor = std::function<void(const NewtonStep &)>;

  /// Print the head of a table, and return a visitor that prints a row for each step.
  StepVisitor
  print_steps(dealii::ConditionalOStream &out);
} // namespace Signorini
