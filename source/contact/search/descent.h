// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/face_patch.h"

namespace Signorini
{
  /// Projected Newton method for the closest point of a face: move xi within the parameter square
  /// [0,1]^(dim-1) down to a local minimum of |x - x(xi)|. False if it has not converged (to 1e-12
  /// of the face's diameter), or to something that is no minimum: a start can lie just on a maximum
  /// or a saddle, and there the gradient knows no way down.
  template <int dim>
  bool
  descend_to_minimum(const dealii::Point<dim> &x,
                     const FacePatch<dim>     &face,
                     dealii::Point<dim - 1>   &xi);
} // namespace Signorini
