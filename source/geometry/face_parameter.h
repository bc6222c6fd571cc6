// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>

#include <vector>

namespace Signorini
{
  /// @return the point of the reference cell that has a parameter on a face, in the convention of
  /// deal.II's QProjector: the parameters follow the normal direction cyclically.
  /// @param face number of the face
  /// @param xi parameter in [0,1]^(dim-1)
  template <int dim>
  dealii::Point<dim>
  unit_point(const unsigned int face, const dealii::Point<dim - 1> &xi)
  {
    dealii::Point<dim> p;
    p[face / 2] = face % 2;
    for (unsigned int d = 0; d < dim - 1; ++d)
      p[(face / 2 + 1 + d) % dim] = xi[d];
    return p;
  }

  /// @return the parameter of a point on a face, the inverse of unit_point().
  /// @param face number of the face
  /// @param p point of the reference cell
  template <int dim>
  dealii::Point<dim - 1>
  face_parameter(const unsigned int face, const dealii::Point<dim> &p)
  {
    dealii::Point<dim - 1> xi;
    for (unsigned int d = 0; d < dim - 1; ++d)
      xi[d] = p[(face / 2 + 1 + d) % dim];
    return xi;
  }

  /// @return the parameters of (k+1)^(dim-1) equidistant points of a face, with the first
  /// coordinate running fastest.
  /// @param k degree, at least 1
  template <int dim>
  std::vector<dealii::Point<dim - 1>>
  face_lattice(const unsigned int k)
  {
    std::vector<dealii::Point<dim - 1>> points;
    for (unsigned int j = 0; j <= (dim == 3 ? k : 0); ++j)
      for (unsigned int i = 0; i <= k; ++i)
        {
          dealii::Point<dim - 1> xi;
          xi[dim - 2] = double(j) / k;
          xi[0]       = double(i) / k;
          points.push_back(xi);
        }
    return points;
  }
} // namespace Signorini
