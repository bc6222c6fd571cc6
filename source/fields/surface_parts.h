// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interface/surface.h"
#include "fields/surface_gradient.h"

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace Signorini
{
  /// A part of a slave face between neighbouring nodes, by the numbers of its corners on the face;
  /// a face of degree k has k^(dim-1) parts. Those of triangles, whose pressure is of degree 1, are
  /// the faces themselves.
  template <int dim>
  using Part = boost::container::static_vector<unsigned int, dim == 2 ? 2 : 4>;

  /// Call visit(part, face) for all parts of all faces.
  /// @param faces the slave faces
  /// @param visit a function of a Part and its SlaveFace
  template <int dim, typename Visit>
  void
  for_each_part(const std::vector<SlaveFace<dim>> &faces, const Visit &visit)
  {
    for (const SlaveFace<dim> &face : faces)
      if (face.degree > 0 && is_triangle(face.reference_cell()))
        visit(Part<dim>{0, 1, 2}, face);
      else
        for (unsigned int j = 0; j < (dim == 3 ? face.degree : std::min(face.degree, 1u)); ++j)
          for (unsigned int i = 0; i < face.degree; ++i)
            {
              Part<dim> part(Part<dim>::static_capacity);
              for (unsigned int c = 0; c < part.size(); ++c)
                part[c] = i + c % 2 + (j + c / 2) * (face.degree + 1);
              visit(part, face);
            }
  }

  /// The linear functions of the corners of a part of a face, and their derivatives, at a point
  /// of a square, which is mapped to triangles so that its upper side becomes the last corner.
  struct PartFunctions
  {
    std::array<double, 4>                value{};
    std::array<std::array<double, 4>, 2> slope{};

    PartFunctions(const unsigned int n_corners, const double s, const double t)
    {
      if (n_corners == 2)
        {
          value    = {{1 - s, s}};
          slope[0] = {{-1, 1}};
        }
      else if (n_corners == 3)
        {
          value    = {{(1 - s) * (1 - t), s * (1 - t), t}};
          slope[0] = {{t - 1, 1 - t, 0}};
          slope[1] = {{s - 1, -s, 1}};
        }
      else
        {
          value    = {{(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
          slope[0] = {{t - 1, 1 - t, -t, t}};
          slope[1] = {{s - 1, -s, 1 - s, s}};
        }
    }
  };

  /// @return the surface gradient in the middle of a part, from the values at its corners.
  /// @param n_corners number of corners
  /// @param positions of the corners
  /// @param values at the corners
  template <int dim>
  dealii::Tensor<1, dim>
  slope_of_part(const unsigned int                                          n_corners,
                const std::array<dealii::Tensor<1, dim>, dim == 2 ? 2 : 4> &positions,
                const std::array<double, dim == 2 ? 2 : 4>                 &values)
  {
    dealii::Tensor<1, dim - 1>                  change;
    std::array<dealii::Tensor<1, dim>, dim - 1> tangents;
    const auto add = [&](const unsigned int c, const unsigned int d, const double factor) {
      change[d] += factor * values[c];
      tangents[d] += factor * positions[c];
    };
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (n_corners == 3)
        {
          add(0, d, -1);
          add(d + 1, d, 1);
        }
      else
        for (unsigned int c = 0; c < n_corners; ++c)
          add(c, d, ((c >> d) % 2 == 1 ? 2. : -2.) / n_corners);
    return surface_gradient<dim>(tangents, change);
  }
} // namespace Signorini
