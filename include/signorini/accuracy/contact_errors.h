#pragma once

#include <signorini/accuracy/quantity.h>
#include <signorini/solve/dual_solution.h>

namespace Signorini
{
  /// Contact points that cannot move, as a corner of the slave that a support holds too: the
  /// support takes their pressure, and nobody knows how much of its reaction that is. What the
  /// mean pressure of the pair would be there, as the quantity feels it: the sum over these points
  /// of area |B z + dJ/dp| times that pressure. Of methods that sample at points: zero. Collective.
  template <int dim>
  double
  undetermined_contact(const Snapshot<dim> &snapshot,
                       const Functional    &functional,
                       const LA::Vector    &dual_displacement);
} // namespace Signorini
