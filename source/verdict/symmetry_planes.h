// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include <signorini/scene/scene.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// A plane on which a support allows a body to slide, and nothing else, at all times.
  template <int dim>
  struct SymmetryPlane
  {
    std::string        boundary;
    unsigned int       body;
    dealii::Point<dim> center;
    /// Outward unit normal of the body.
    dealii::Tensor<1, dim> normal;
  };

  /// @return the planes that supports may represent as symmetry: of Type symmetry, or plane
  /// boundaries constrained along their normal only. Collective.
  /// @param scene the scene
  /// @param elasticity the model
  template <int dim>
  std::vector<SymmetryPlane<dim>>
  symmetry_planes(const Scene<dim> &scene, const Elasticity<dim> &elasticity);
} // namespace Signorini
