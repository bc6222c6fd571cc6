// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
#include <signorini/accuracy/known_solution.h>

namespace Signorini
{
  /// Deviations from a known solution, each relative to the norm of the exact field; zero where
  /// that is not known.
  struct SolutionErrors
  {
    /// In L2.
    double displacement = 0;
    /// In the energy norm (int sigma(e):eps(e) dV)^1/2; in displacement-pressure form without the
    /// volumetric stress.
    double energy = 0;
    /// In L2, over bodies in displacement-pressure form.
    double volumetric_stress = 0;
    /// In L2, over the contact points of the slave surfaces.
    double pressure = 0;
    /// The same norm for the reported pressure, see recovered_pressure().
    double recovered_pressure = 0;
  };

  /// @return the errors of a solution. Collective.
  /// @param snapshot the solution
  /// @param exact the known solution
  template <int dim>
  SolutionErrors
  errors(const Snapshot<dim> &snapshot, const KnownSolution<dim> &exact);
} // namespace Signorini
