// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <string>
#include <vector>

namespace Signorini
{
  /// A point of a slave surface with the solution there.
  template <int dim>
  struct SurfaceValue
  {
    /// Position in the reference configuration, on the true surface.
    dealii::Point<dim> place;
    /// Displacement of the slave.
    dealii::Tensor<1, dim> displacement;
    /// Recovered pressure, positive in compression.
    double pressure = 0;
    /// Gap [length], positive where open; NaN where surfaces are too far apart for the search.
    double gap = 0;
  };

  /// Throws SceneError for a point beside the surface. Collective.
  /// @param elasticity the model
  /// @param boundary name of the surface
  /// @param points to be checked
  /// @param tolerance allowed tangential offset in units of a face; half of the distance from the
  /// surface is allowed in addition
  /// @param which beginning of the message
  template <int dim>
  void
  check_on_surface(const Elasticity<dim>                 &elasticity,
                   const std::string                     &boundary,
                   const std::vector<dealii::Point<dim>> &points,
                   double                                 tolerance,
                   const std::string                     &which);

  /// @return the solution at the point of the slave that is closest to each given point, the same
  /// on all ranks. Nodal fields are interpolated; for methods that sample at points these are means
  /// around nodes. Throws SceneError as check_on_surface() does. Collective.
  /// @param snapshot the solution
  /// @param pair its index
  /// @param points any number
  /// @param which beginning of the message
  template <int dim>
  std::vector<SurfaceValue<dim>>
  evaluate_on_slave(const Snapshot<dim>                   &snapshot,
                    unsigned int                           pair,
                    const std::vector<dealii::Point<dim>> &points,
                    const std::string                     &which);
} // namespace Signorini
