// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

namespace Signorini
{
  /// Where the next function is beyond that, a peak is not resolved: errors of Hertz' peaks, of
  /// rounded edges and of thin plates below it are up to 0.8 times its value, and any beyond.
  constexpr double sharp_peak = 0.15;

  /// By how much the largest nodal pressure differs from the linear continuation of those around
  /// it, on its faces and the next ones as far as these are in contact, as a share of it. Of a
  /// smooth pressure that is the square of the size of faces over the width of its peak, which is
  /// the order of its error, too; where the pressure is singular, as at an edge, no mesh makes it
  /// small; of linear pressures, and of fewer nodes than tell a linear one, it is zero. Collective.
  /// @param pressure recovered_pressure()
  template <int dim>
  double
  sharpness_of_peak(const Snapshot<dim> &snapshot, unsigned int pair, const LA::Vector &pressure);
} // namespace Signorini
