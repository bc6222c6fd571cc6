// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "fields/surface_gradient.h"

#include <algorithm>
#include <array>
#include <vector>

namespace Signorini
{
  /// A part of a slave face between neighbouring nodes, by the numbers of its corners on the face;
  /// a face of degree k has k^(dim-1) parts.
  template <int dim>
  using Part = std::array<unsigned int, dim == 2 ? 2 : 4>;

  /// Call visit(part, face) for all parts of all faces.
  /// @param faces the slave faces
  /// @param visit a function of a Part and its SlaveFace
  template <int dim, typename Visit>
  void
  for_each_part(const std::vector<SlaveFace<dim>> &faces, const Visit &visit)
  {
    for (const SlaveFace<dim> &face : faces)
      for (unsigned int j = 0; j < (dim == 3 ? face.degree : std::min(face.degree, 1u)); ++j)
        for (unsigned int i = 0; i < face.degree; ++i)
          {
            Part<dim> part;
            for (unsigned int c = 0; c < part.size(); ++c)
              part[c] = i + c % 2 + (j + c / 2) * (face.degree + 1);
            visit(part, face);
          }
  }

  /// @return the surface gradient in the middle of a part, from the values at its corners.
  /// @param positions of the corners
  /// @param values at the corners
  template <int dim>
  dealii::Tensor<1, dim>
  slope_of_part(const std::array<dealii::Tensor<1, dim>, dim == 2 ? 2 : 4> &positions,
                const std::array<double, dim == 2 ? 2 : 4>                 &values)
  {
    constexpr unsigned int                      n = dim == 2 ? 2 : 4;
    dealii::Tensor<1, dim - 1>                  change;
    std::array<dealii::Tensor<1, dim>, dim - 1> tangents;
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          const double sign = ((c >> d) % 2 == 1 ? 1. : -1.) / (n / 2);
          change[d] += sign * values[c];
          tangents[d] += sign * positions[c];
        }
    return surface_gradient<dim>(tangents, change);
  }
} // namespace Signorini
