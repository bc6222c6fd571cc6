#pragma once

#include <signorini/contact/geometry/boundary_faces.h>
#include <signorini/contact/geometry/search.h>

namespace Signorini
{
  /// The master side of a pair: faces with what a partner on them has to tell of their body.
  /// @param with_stress also its normal stress
  /// @param with_bend also how the gap bends, all but the factors
  template <int dim>
  MasterFaces<dim>
  master_faces(const Elasticity<dim>    &elasticity,
               const BoundaryFaces<dim> &boundary,
               bool                      with_stress,
               bool                      with_bend);
} // namespace Signorini
