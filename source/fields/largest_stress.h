// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <array>
#include <vector>

namespace Signorini
{
  /// A value and where it occurs.
  template <int dim>
  struct ValueAtPosition
  {
    double value = 0;
    /// Position in the reference configuration.
    dealii::Point<dim> position;
  };

  /// The largest stresses of one body at the superconvergent points of its cells, where stresses
  /// are most accurate. They are inside the cells, so that stresses directly at the surface are not
  /// among them.
  template <int dim>
  struct LargestStresses
  {
    /// Largest von Mises stress, largest shear stress (s1 - s3)/2 (Tresca), and largest (most
    /// tensile) principal stress.
    ValueAtPosition<dim> von_mises, shear, principal;
  };

  /// @return the largest stresses of each body, the same on all ranks. Collective.
  /// @param elasticity the model
  /// @param displacement without ghost values
  template <int dim>
  std::vector<LargestStresses<dim>>
  largest_stresses(const Elasticity<dim> &elasticity, const LA::Vector &displacement);
} // namespace Signorini
