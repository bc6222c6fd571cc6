// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/scene/scene.h>

#include <deal.II/base/bounding_box.h>

namespace Signorini
{
  /// @return an estimate of the largest motion [length] of bodies and obstacles in the load
  /// history: prescribed motions, the deformation of a cube of the softest material by the loads,
  /// and thermal expansion, by formulas at a few points.
  /// @param scene the scene
  /// @param extent bounding box of all bodies
  template <int dim>
  double
  expected_motion(const Scene<dim> &scene, const dealii::BoundingBox<dim> &extent);
} // namespace Signorini
