// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

#include <deal.II/base/conditional_ostream.h>

#include <functional>
#include <string>
#include <vector>

namespace Signorini
{
  struct NewtonStep
  {
    unsigned int active = 0, changes = 0, krylov_iterations = 0;
    double       residual = 0, gap_residual = 0, damping = 1;
    double       residual_of_bodies =
      0; ///< the largest one of a body, see ConvergenceCriteria::reference_forces()
    bool kept_previous_set = false; ///< takes over the active set of the last load step
    bool restricted_set =
      false; ///< overlapping points are not active yet, see restrict_to_deepest()
    bool augmented           = false; ///< a solution, from which the next augmentation starts
    bool fell_back_to_direct = false; ///< iterating: the system is factorised from this step on
  };

  struct NewtonReport
  {
    bool                    converged = false;
    std::string             reason; ///< why not
    std::vector<NewtonStep> steps;
    /// Motions that neither supports nor contact determine: they are held, by at most that force.
    std::vector<std::string> undetermined_modes;
    double                   stabilisation_force     = 0;
    bool                     has_unconstrained_modes = false; ///< that is why it did not converge
    LA::Vector               chattering; ///< if not: 1 at the contact points that change to and fro
    /// The solution, or what was tried where there is none, may be unstable, see
    /// Newton::tangent_is_indefinite(); where that was asked for.
    bool tangent_is_indefinite = false;
    /// How many times as far per time as in the load step before the bodies have moved, if that is
    /// more than 3, and the tangent curves down somewhere on the straight way; else 0.
    double       speed_ratio = 0;
    unsigned int worst_body  = dealii::numbers::invalid_unsigned_int; ///< likewise, out of balance

    bool
    is_finished() const
    {
      return converged || !reason.empty();
    }
  };

  /// What is done after each step.
  using StepVisitor = std::function<void(const NewtonStep &)>;

  /// Prints the head of a table now, and a row each step.
  StepVisitor
  print_steps(dealii::ConditionalOStream &out);
} // namespace Signorini
