// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "multigrid/level.h"
#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// Degree one on the same mesh, where bodies have more, then coarser meshes in three dimensions,
  /// as far as supports do not get lost. There may be none: of large deformation, where the
  /// stiffness does not know the tangents of cells. Collective.
  /// @param stiffness of the bodies
  /// @param to_coarser_meshes false: none of these
  template <int dim>
  Spaces
  make_spaces(const Elasticity<dim> &elasticity,
              const Stiffness       &stiffness,
              bool                   to_coarser_meshes);
} // namespace Signorini
