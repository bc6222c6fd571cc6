// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <vector>

namespace Signorini
{
  /// A set of boundary faces that are connected without a kink.
  template <int dim>
  struct SmoothPatch
  {
    /// Indices into the list of faces, in ascending order.
    std::vector<unsigned int> faces;
    /// The centre of gravity of the patch.
    dealii::Point<dim> center;
  };

  /// Divide faces into patches where they meet at more than a feature angle.
  /// @param faces with vertices in deal.II's order
  /// @param vertices of the mesh
  /// @param angle [degrees] between the normals of neighbouring faces above which they are in
  /// different patches; 0 is flat
  /// @return the patches in the order of the first coordinate of their centres, then of the second,
  /// the third, and of their extent: an order that does not depend on the numbers of nodes and
  /// elements
  template <int dim>
  std::vector<SmoothPatch<dim>>
  smooth_patches(const std::vector<dealii::CellData<dim - 1>> &faces,
                 const std::vector<dealii::Point<dim>>        &vertices,
                 double                                        angle);
} // namespace Signorini
