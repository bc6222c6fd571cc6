// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include <signorini/accuracy/known_solution.h>

namespace Signorini
{
  /// Deviations from the known solution, each relative to the norm of the solution itself; zero
  /// where it is not known.
  struct SolutionErrors
  {
    double displacement = 0; ///< in L2
    double energy       = 0; ///< (int sigma(e):eps(e) dV)^1/2; mixed: without volumetric stress
    double volumetric_stress  = 0; ///< in L2, on mixed bodies
    double pressure           = 0; ///< in L2 on the slave surfaces where they have a projection
    double recovered_pressure = 0; ///< of what is reported, see recovered_pressure()
  };

  /// Collective.
  template <int dim>
  SolutionErrors
  errors(const Snapshot<dim> &snapshot, const KnownSolution<dim> &exact);
} // namespace Signorini
