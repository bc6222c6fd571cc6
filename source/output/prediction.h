// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/scene/scene.h>

namespace Signorini
{
  /// What a run will take, by a small model: what it has taken up to now, so many times the seconds
  /// of assembly, which are measured on a few cells, for each cell and contact point, and so many
  /// bytes an entry of the stiffness matrix (that there is, or would be) and point. Within a factor
  /// of two for the seconds and 30 % for the memory of usual scenes; scripts/calibrate compares.
  struct Prediction
  {
    double seconds_per_cell = 0; ///< of assembly, measured here and now
    double seconds          = 0; ///< of the whole run; NaN for a direct solver, as the memory
    double seconds_before   = 0; ///< until now: mesh, search
    double memory_mb        = 0; ///< largest of a rank
  };

  /// Collective. Of the mesh as it is and the refinements to come.
  /// @param n_points contact points of this rank
  /// @param seconds since the start; what they did is done again on each mesh, surface by surface
  template <int dim>
  Prediction
  predict(const Scene<dim>      &scene,
          const Elasticity<dim> &elasticity,
          unsigned int           n_points,
          double                 seconds);
} // namespace Signorini
