// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <array>
#include <vector>

namespace Signorini
{
  template <int dim>
  struct ValueAtPosition
  {
    double             value = 0;
    dealii::Point<dim> position; ///< at rest
  };

  /// The largest stresses of one body at the superconvergent points of its cells, where stresses
  /// are most accurate: half a cell and more below the surface.
  template <int dim>
  struct LargestStresses
  {
    ValueAtPosition<dim> von_mises, shear, principal; ///< (s1 - s3)/2 of Tresca; most tensile
  };

  /// Body by body. Collective.
  template <int dim>
  std::vector<LargestStresses<dim>>
  largest_stresses(const Elasticity<dim> &elasticity, const LA::Vector &displacement);
} // namespace Signorini
