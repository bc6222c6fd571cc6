// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/scene/scene.h>

#include <deal.II/base/bounding_box.h>

namespace Signorini
{
  /// How far bodies and obstacles are likely to move within the load history: what is prescribed,
  /// what the loads would do to a cube of the softest material, and by how much temperatures change
  /// the size of the scene. A guess, from formulas at a few points of the scene.
  template <int dim>
  double
  expected_motion(const Scene<dim> &scene, const dealii::BoundingBox<dim> &extent);
} // namespace Signorini
