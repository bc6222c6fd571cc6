// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <vector>

namespace Signorini
{
  /// Faces, connected without a kink.
  template <int dim>
  struct SmoothPatch
  {
    std::vector<unsigned int> faces;  ///< indices into the list of faces
    dealii::Point<dim>        center; ///< of gravity
  };

  /// Divide faces (with vertices in deal.II's order) where they meet at an angle of more than
  /// `angle` degrees, 0 being flat. The patches come in the order of the first coordinate of their
  /// centers, then of the second, then of the third, then of their size.
  template <int dim>
  std::vector<SmoothPatch<dim>>
  smooth_patches(const std::vector<dealii::CellData<dim - 1>> &faces,
                 const std::vector<dealii::Point<dim>>        &vertices,
                 double                                        angle);
} // namespace Signorini
