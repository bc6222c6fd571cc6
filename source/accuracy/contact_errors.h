// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include "solver/dual_solution.h"

#include <vector>

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

  /// Where the edge of contact crosses a face, nobody knows where on it the force acts: half of the
  /// standard deviation of (B z + dJ/dp) there times the force, of the cells of such faces. Small
  /// of zones of many faces. Collective.
  template <int dim>
  std::vector<double>
  unresolved_contact(const Snapshot<dim> &snapshot,
                     const Functional    &functional,
                     const LA::Vector    &dual_displacement);

  /// Exact minus computed, cell by cell, because nodes that a support holds have no pressure of
  /// their own, and their neighbours stand for it: the sum of (B z + dJ/dp) p* dA over the faces
  /// about such nodes, where the dual solution is not orthogonal to p*, the recovered pressure. Of
  /// methods that sample at points: zero. Collective.
  template <int dim>
  std::vector<double>
  dirichlet_contact_errors(const Snapshot<dim> &snapshot,
                           const Functional    &functional,
                           const LA::Vector    &dual_displacement);
} // namespace Signorini
