// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// If sharpness_of_peak() is larger than this, the peak is not resolved: in the measured cases
  /// (Hertz contact, rounded edges, thin plates) the relative error is at most 0.8 of the sharpness
  /// below it, and may have any size above.
  constexpr double sharp_peak = 0.15;

  /// @return the relative difference of the largest nodal pressure from the linear continuation of
  /// the pressures around it, on its faces and the next ones as far as these are in contact. For a
  /// smooth pressure it is of the order of the squared ratio of the face size and the width of the
  /// peak, which is also the order of the error; where the pressure is singular, as at an edge, it
  /// stays large on any mesh; for linear pressures, and for too few nodes to determine a linear
  /// function, it is zero. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param pressure recovered_pressure() of the pair
  template <int dim>
  double
  sharpness_of_peak(const Snapshot<dim> &snapshot, unsigned int pair, const LA::Vector &pressure);
} // namespace Signorini
