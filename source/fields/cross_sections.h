// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solid/resultant.h"
#include <signorini/fields/cross_section.h>

#include <vector>

namespace Signorini
{
  /// Throws SceneError on all ranks where a plane cuts none of its bodies. Collective.
  template <int dim>
  void
  check_cross_sections(const Elasticity<dim>                &elasticity,
                       const std::vector<CrossSection<dim>> &sections);

  /// The force that the part of the bodies beyond each plane exerts on the part before it, tension
  /// along the normal, and its moment about the point of the plane; at finite strain with the
  /// levers of the displaced nodes. They are the sums of the internal forces of the cut cells over
  /// their nodes beyond the plane: with all loads on these nodes they are in equilibrium to the
  /// tolerance of Newton's method, wherever the plane cuts the cells. Axisymmetric: the axial force
  /// alone. Collective.
  template <int dim>
  std::vector<Resultant<dim>>
  section_resultants(const Elasticity<dim>                &elasticity,
                     const LA::Vector                     &u,
                     const std::vector<CrossSection<dim>> &sections);
} // namespace Signorini
