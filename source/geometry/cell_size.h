// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/cell_rule.h"
#include "geometry/face_parameter.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Signorini
{
  // Sizes of multilinear cells and straight simplices. TriaAccessor::measure() multiplies
  // coordinates with each other, so that no digit of a volume is left 1e5 cell sizes away from the
  // origin. These functions use differences of vertices only.

  /// @return the columns dx/dxi_d of the Jacobian at a point of the reference cell.
  /// @param cell any cell
  /// @param unit reference coordinates
  template <typename Cell, int dim = Cell::AccessorType::dimension>
  std::array<dealii::Tensor<1, dim>, dim>
  edges_at(const Cell &cell, const dealii::Point<dim> &unit)
  {
    std::array<dealii::Tensor<1, dim>, dim> edges;
    if (cell->reference_cell().is_simplex())
      {
        for (unsigned int d = 0; d < dim; ++d)
          edges[d] = cell->vertex(d + 1) - cell->vertex(0);
        return edges;
      }
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

  /// @return the determinants of the map from the reference cell at the corners of a multilinear
  /// cell, or the one of a straight simplex: the cell is valid if all are positive.
  /// @param corners of the cell in deal.II's order
  template <int dim>
  std::vector<double>
  determinants_at_corners(const std::vector<dealii::Point<dim>> &corners)
  {
    if (corners.size() == dim + 1)
      {
        dealii::Tensor<2, dim> edges;
        for (unsigned int d = 0; d < dim; ++d)
          edges[d] = corners[d + 1] - corners[0];
        return {dealii::determinant(edges)};
      }
    constexpr unsigned int n = dealii::GeometryInfo<dim>::vertices_per_cell;
    dealii::Point<dim>     vertices[n];
    dealii::Tensor<0, dim> forms[n];
    std::copy(corners.begin(), corners.end(), vertices);
    dealii::GeometryInfo<dim>::alternating_form_at_vertices(vertices, forms);
    return {forms, forms + n};
  }

  /// @return the volume [length^dim], exact for multilinear cells; negative if the cell is
  /// inverted.
  /// @param cell any cell
  template <typename Cell, int dim = Cell::AccessorType::dimension>
  double
  volume_of(const Cell &cell)
  {
    const dealii::Quadrature<dim> &rule = cell_rule<dim>(cell->reference_cell(), 2);
    double                         sum  = 0;
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
    const auto                         reference = cell->reference_cell();
    const dealii::Quadrature<dim - 1> &rule =
      cell_rule<dim - 1>(reference.face_reference_cell(face), 2);
    double sum = 0;
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const auto edges =
          edges_at<Cell, dim>(cell, unit_point<dim>(reference, face, rule.point(q)));
        std::array<dealii::Tensor<1, dim>, dim - 1> tangents;
        for (unsigned int a = 0; a < dim - 1; ++a)
          {
            const auto direction = face_direction<dim>(reference, face, a);
            for (unsigned int d = 0; d < dim; ++d)
              tangents[a] += direction[d] * edges[d];
          }
        if constexpr (dim == 2)
          sum += rule.weight(q) * tangents[0].norm();
        else
          sum += rule.weight(q) * dealii::cross_product_3d(tangents[0], tangents[1]).norm();
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
