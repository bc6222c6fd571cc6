// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"

namespace Signorini
{
  /// Projected Newton method for the closest point of a face: move xi within the parameter square
  /// [0,1]^(dim-1) to a local minimum of |x - x(xi)|.
  /// @param xi in: start; out: the last iterate
  /// @return false if it has not converged to 1e-12 of the face's diameter, or has converged to a
  /// stationary point that is no minimum: a start on a maximum or a saddle point has no direction
  /// of descent
  template <int dim>
  bool
  descend_to_minimum(const dealii::Point<dim> &x,
                     const FacePatch<dim>     &face,
                     dealii::Point<dim - 1>   &xi);
} // namespace Signorini
