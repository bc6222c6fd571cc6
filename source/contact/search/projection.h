// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"

namespace Signorini
{
  /// Closest point projection of x onto one face (doc/theory, 3.1).
  template <int dim>
  struct Projection
  {
    dealii::Point<dim - 1> xi;       ///< parameter of the closest point, in [0,1]^(dim-1)
    dealii::Point<dim>     position; ///< the closest point
    double                 distance; ///< |x - position| >= 0
    /// Length of the part of x - position that is tangential to the face: zero where the closest
    /// point is a true normal projection, positive where it lies on the rim of the face.
    double tangential_offset;
    bool   converged_by_newton; ///< true: found by Newton's method; false: by the fallback
  };

  /// Minimise |x - x(xi)|^2 over the parameter square [0,1]^(dim-1). Projected Newton iterations
  /// start from every local minimum of a grid of samples, see descend_to_minimum(); where they do
  /// not converge, a derivative-free shrinking grid search ends with the same accuracy, 1e-12 of
  /// the face's diameter (plus the rounding of coordinates). Of several minima the least one is
  /// found if the samples resolve them; for faces that are more bumpy than any mesh should be
  /// (nodes off by a fifth of their spacing) about 1 of 1000 points misses it.
  template <int dim>
  Projection<dim>
  project(const dealii::Point<dim> &x, const FacePatch<dim> &face);
} // namespace Signorini
