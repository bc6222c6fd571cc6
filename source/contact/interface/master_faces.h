// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/search/boundary_faces.h"
#include "contact/search/search.h"

namespace Signorini
{
  /// The master side of a pair: its faces, and a function that completes a projection by what
  /// depends on the body: shape functions, stiffness, and in displaced configurations the second
  /// variation of the gap (without its factors).
  /// @param with_stress also the normal stress, for Nitsche's method
  template <int dim>
  MasterFaces<dim>
  master_faces(const Configuration<dim> &configuration,
               const BoundaryFaces<dim> &boundary,
               bool                      with_stress);
} // namespace Signorini
