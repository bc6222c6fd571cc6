// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/cells.h"

#include <deal.II/base/tensor.h>

namespace Signorini
{
  /// @return the mean of the coordinates of some vertices.
  /// @param nodes indices into `vertices`
  /// @param vertices all vertices of the mesh
  template <int dim>
  dealii::Point<dim>
  center_of(const std::vector<unsigned int> &nodes, const std::vector<dealii::Point<dim>> &vertices)
  {
    dealii::Point<dim> center;
    for (const unsigned int node : nodes)
      center += vertices[node] / double(nodes.size());
    return center;
  }

  /// @return the rims at which a face meets others, each as sorted indices of vertices: its two
  /// vertices in 2D, its three or four edges in 3D.
  /// @param v the vertices of the face, in deal.II's order
  template <int dim>
  std::vector<std::vector<unsigned int>>
  rims_of(const std::vector<unsigned int> &v)
  {
    if (dim == 2)
      return {{v[0]}, {v[1]}};
    if (v.size() == 3)
      return {sorted({v[0], v[1]}), sorted({v[1], v[2]}), sorted({v[2], v[0]})};
    return {sorted({v[0], v[1]}), sorted({v[2], v[3]}), sorted({v[0], v[2]}), sorted({v[1], v[3]})};
  }

  /// Unit vector from the rim into the face, normal to the rim.
  template <int dim>
  dealii::Tensor<1, dim>
  inward(const std::vector<unsigned int>       &rim,
         const std::vector<unsigned int>       &face,
         const std::vector<dealii::Point<dim>> &vertices)
  {
    dealii::Tensor<1, dim> arm = center_of(face, vertices) - center_of(rim, vertices);
    if (rim.size() == 2)
      {
        const dealii::Tensor<1, dim> along = vertices[rim[1]] - vertices[rim[0]];
        arm -= (arm * along) / along.norm_square() * along;
      }
    return arm / arm.norm();
  }
} // namespace Signorini
