// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "accuracy/quantity.h"
#include "solver/dual_solution.h"

#include <vector>

namespace Signorini
{
  /// @return the size of the error by contact points that cannot move, such as a corner of the
  /// slave at a support: the support takes their pressure, and its share of the reaction is not
  /// determined. The mean pressure of the pair is assumed there: the sum over these points of area
  /// |B z + dJ/dp| times that pressure. Zero for methods that sample at quadrature points.
  /// Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  double
  undetermined_contact(const Snapshot<dim> &snapshot,
                       const Functional    &functional,
                       const LA::Vector    &dual_displacement);

  /// @return the size of the error by faces that the edge of contact crosses, (8.9), on each active
  /// cell: the position of the force within such a face is not resolved. It is small for contact
  /// zones of many faces. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  std::vector<double>
  unresolved_contact(const Snapshot<dim> &snapshot,
                     const Functional    &functional,
                     const LA::Vector    &dual_displacement);

  /// @return the error, exact minus computed, on each active cell because nodes at supports have no
  /// multiplier, (8.8), where the dual solution is not orthogonal to the recovered pressure p*.
  /// Zero for methods that sample at quadrature points. Collective.
  /// @param snapshot the solution
  /// @param functional the quantity
  /// @param dual_displacement z of the quantity, without its lift
  template <int dim>
  std::vector<double>
  dirichlet_contact_errors(const Snapshot<dim> &snapshot,
                           const Functional    &functional,
                           const LA::Vector    &dual_displacement);
} // namespace Signorini
