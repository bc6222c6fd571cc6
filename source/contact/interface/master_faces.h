// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"

namespace Signorini
{
  /// The master side of a pair: faces with what a projection on them has to tell of their body.
  /// Where surfaces have moved, also how the gap bends, all but the factors.
  /// @param with_stress also its normal stress
  template <int dim>
  MasterFaces<dim>
  master_faces(const Configuration<dim> &configuration,
               const BoundaryFaces<dim> &boundary,
               bool                      with_stress);
} // namespace Signorini
