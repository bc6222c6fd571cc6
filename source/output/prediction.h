// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/scene/scene.h>

namespace Signorini
{
  /// The predicted costs of a run by a simple model: the time so far, plus multiples of the
  /// assembly time, which is measured on a few cells, for each cell and contact point; and a number
  /// of bytes for each entry of the stiffness matrix (whether or not it is assembled) and contact
  /// point. For usual scenes the time is right within a factor of two, and the memory within 30 %;
  /// scripts/calibrate compares.
  struct Prediction
  {
    /// Time of assembling one cell [s], as measured.
    double seconds_per_cell = 0;
    /// Time of the whole run [s]; NaN for direct solvers and finite strain.
    double seconds = 0;
    /// Time so far [s]: mesh and search.
    double seconds_before = 0;
    /// Largest memory of a rank [MB]; NaN for direct solvers.
    double memory_mb = 0;
  };

  /// @return the predicted costs, for the present mesh and the refinements to come. Collective.
  /// @param scene the scene
  /// @param elasticity the model on the present mesh
  /// @param n_points contact points of this rank
  /// @param seconds since the start of the program; this work is repeated on each mesh, in
  /// proportion to its surface
  template <int dim>
  Prediction
  predict(const Scene<dim>      &scene,
          const Elasticity<dim> &elasticity,
          unsigned int           n_points,
          double                 seconds);
} // namespace Signorini
