#pragma once

#include <signorini/scene/scene.h>

#include <deal.II/base/bounding_box.h>

namespace Signorini
{
  /// How far bodies and obstacles are likely to move within the load history: what is prescribed,
  /// and what the loads would do to a cube of the softest material. A guess, from formulas at the
  /// corners and the center of the scene.
  template <int dim>
  double
  expected_motion(const Scene<dim> &scene, const dealii::BoundingBox<dim> &extent);
} // namespace Signorini
