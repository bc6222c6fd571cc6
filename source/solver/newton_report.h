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
    double residual_of_bodies = 0;     ///< the largest one of a body, see Balance::forces_at_work()
    bool   follows            = false; ///< takes over the active set of the last load step
    bool   withholds = false; ///< overlapping points are not active yet, see keep_deepest()
    bool   augments  = false; ///< a solution, from which the next augmentation starts
    bool   gives_up  = false; ///< iterating: the system is factorised from this step on
  };

  struct NewtonReport
  {
    bool                    converged = false;
    std::string             reason; ///< why not
    std::vector<NewtonStep> steps;
    /// Motions that neither supports nor contact determine: they are held, by at most that force.
    std::vector<std::string> undetermined;
    double                   holding_force = 0;
    bool                     is_loose      = false; ///< that is why it did not converge
    LA::Vector               chattering; ///< if not: 1 at the contact points that change to and fro
    /// The solution, or what was tried where there is none, may be unstable, see
    /// Newton::curves_down(); where that was asked for.
    bool curves_down = false;
    /// How many times as far per time as in the load step before the bodies have moved, if that is
    /// more than 3, and the tangent curves down somewhere on the straight way; else 0.
    double       jump       = 0;
    unsigned int worst_body = dealii::numbers::invalid_unsigned_int; ///< likewise, out of balance

    bool
    is_over() const
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
