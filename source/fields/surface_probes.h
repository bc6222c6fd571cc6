// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"

#include <string>
#include <vector>

namespace Signorini
{
  /// A place of a slave surface with what is there.
  template <int dim>
  struct SurfaceValue
  {
    dealii::Point<dim>     place;        ///< at rest, on the true surface
    dealii::Tensor<1, dim> displacement; ///< of the slave
    double                 pressure = 0; ///< recovered, positive in compression
    double                 gap = 0; ///< positive where open; not a number: too far for candidates
  };

  /// Throws SceneError, beginning with `which`, for a point that lies beside the surface by more
  /// than that share of a face, or of its distance from the surface. Collective.
  template <int dim>
  void
  check_on_surface(const Elasticity<dim>                 &elasticity,
                   const std::string                     &boundary,
                   const std::vector<dealii::Point<dim>> &points,
                   double                                 tolerance,
                   const std::string                     &which);

  /// The slave of a pair where it is closest to each point, the same on all ranks. Nodal fields are
  /// interpolated, of methods that sample at points their means about nodes. Throws SceneError as
  /// check_on_surface() does. Collective.
  template <int dim>
  std::vector<SurfaceValue<dim>>
  evaluate_on_slave(const Snapshot<dim>                   &snapshot,
                    unsigned int                           pair,
                    const std::vector<dealii::Point<dim>> &points,
                    const std::string                     &which);
} // namespace Signorini
