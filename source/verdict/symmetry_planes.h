// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// A plane on which a support lets a body slide, and nothing else, at all times.
  template <int dim>
  struct SymmetryPlane
  {
    std::string            boundary;
    unsigned int           body;
    dealii::Point<dim>     center;
    dealii::Tensor<1, dim> normal; ///< out of the body
  };

  /// The symmetry planes that supports may represent: of Type symmetry, or plane boundaries
  /// constrained along their normal alone. Collective.
  template <int dim>
  std::vector<SymmetryPlane<dim>>
  symmetry_planes(const Scene<dim> &scene, const Elasticity<dim> &elasticity);
} // namespace Signorini
