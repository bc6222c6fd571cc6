// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fields/snapshot.h"
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

  /// What the part of the bodies beyond a plane exerts on the part before it.
  template <int dim>
  struct SectionForce
  {
    /// Tension along the normal of the plane is positive; the moment is about the point of the
    /// plane, at finite strain with the levers of the displaced nodes.
    Resultant<dim> resultant;
    /// Sum of the sizes of the forces of loads and contact on the nodes of the cells that are cut:
    /// on which side of the plane they act is not known.
    double uncertainty = 0;
  };

  /// The forces across planes: the sums of the internal forces of the cut cells over their nodes
  /// beyond the plane, without the terms of Nitsche's method that are no tractions. With all loads
  /// at their nodes they are in equilibrium to the tolerance of Newton's method, wherever the plane
  /// cuts the cells. Axisymmetric: the axial force alone. Collective.
  template <int dim>
  std::vector<SectionForce<dim>>
  section_forces(const Snapshot<dim> &snapshot, const std::vector<CrossSection<dim>> &sections);
} // namespace Signorini
