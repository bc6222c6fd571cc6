// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/face_parameter.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>

namespace Signorini
{
  // Sizes of multilinear cells. TriaAccessor::measure() multiplies coordinates with each other, so
  // that no digit of a volume is left 1e5 cell sizes away from the origin. These functions use
  // differences of vertices only.

  /// @return the columns dx/dxi_d of the Jacobian at a point of the reference cell.
  /// @param cell any cell
  /// @param unit reference coordinates
  template <typename Cell, int dim = Cell::AccessorType::dimension>
  std::array<dealii::Tensor<1, dim>, dim>
  edges_at(const Cell &cell, const dealii::Point<dim> &unit)
  {
    std::array<dealii::Tensor<1, dim>, dim> edges;
    for (const unsigned int v : cell->vertex_indices())
      {
        const dealii::Tensor<1, dim> arm = cell->vertex(v) - cell->vertex(0);
        const dealii::Tensor<1, dim> slope =
          dealii::GeometryInfo<dim>::d_linear_shape_function_gradient(unit, v);
        for (unsigned int d = 0; d < dim; ++d)
          edges[d] += slope[d] * arm;
      }
    return edges;
  }

  /// @return the volume [length^dim], exact for multilinear cells; negative if the cell is
  /// inverted.
  /// @param cell any cell
  template <typename Cell, int dim = Cell::AccessorType::dimension>
  double
  volume_of(const Cell &cell)
  {
    static const dealii::QGauss<dim> rule(2);
    double                           sum = 0;
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const auto edges = edges_at<Cell, dim>(cell, rule.point(q));
        double     determinant;
        if constexpr (dim == 2)
          determinant = -(dealii::cross_product_2d(edges[0]) * edges[1]);
        else
          determinant = dealii::cross_product_3d(edges[0], edges[1]) * edges[2];
        sum += rule.weight(q) * determinant;
      }
    return sum;
  }

  /// @return the area [length^(dim-1)] of a face; exact if the face is plane.
  /// @param cell any cell
  /// @param face number of the face
  template <typename Cell, int dim = Cell::AccessorType::dimension>
  double
  area_of_face(const Cell &cell, const unsigned int face)
  {
    static const dealii::QGauss<dim - 1> rule(2);
    double                               sum = 0;
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const auto  edges = edges_at<Cell, dim>(cell, unit_point<dim>(face, rule.point(q)));
        const auto &first = edges[(face / 2 + 1) % dim];
        if constexpr (dim == 2)
          sum += rule.weight(q) * first.norm();
        else
          sum +=
            rule.weight(q) * dealii::cross_product_3d(first, edges[(face / 2 + 2) % dim]).norm();
      }
    return sum;
  }

  /// @return the mean depth [length] of a cell behind one of its faces, volume over area.
  /// @param cell any cell
  /// @param face number of the face
  template <typename Cell>
  double
  depth_behind(const Cell &cell, const unsigned int face)
  {
    return volume_of(cell) / area_of_face(cell, face);
  }
} // namespace Signorini
