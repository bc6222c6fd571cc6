// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/reference_cell.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Signorini
{
  /// @return the two vertices of a line of a reference cell.
  /// @param cell the reference cell, a hypercube or a simplex of 2 or 3 dimensions
  /// @param line its number
  inline std::array<unsigned int, 2>
  ends_of_line(const dealii::ReferenceCell &cell, const unsigned int line)
  {
    using namespace dealii;
    if (cell == ReferenceCells::Quadrilateral)
      return {{GeometryInfo<2>::line_to_cell_vertices(line, 0),
               GeometryInfo<2>::line_to_cell_vertices(line, 1)}};
    if (cell == ReferenceCells::Hexahedron)
      return {{GeometryInfo<3>::line_to_cell_vertices(line, 0),
               GeometryInfo<3>::line_to_cell_vertices(line, 1)}};
    constexpr std::array<std::array<unsigned int, 2>, 6> of_simplices{
      {{{0, 1}}, {{1, 2}}, {{2, 0}}, {{0, 3}}, {{1, 3}}, {{2, 3}}}};
    return of_simplices[line];
  }

  /// @return the derivative of unit_point() by one of the parameters: an edge of the face.
  /// @param cell the reference cell, a hypercube or a simplex
  /// @param face number of the face
  /// @param d number of the parameter
  template <int dim>
  dealii::Tensor<1, dim>
  face_direction(const dealii::ReferenceCell &cell, const unsigned int face, const unsigned int d)
  {
    if (cell.is_hyper_cube())
      return dealii::Point<dim>::unit_vector((face / 2 + 1 + d) % dim);
    return cell.vertex<dim>(cell.face_to_cell_vertices(face, d + 1, 1)) -
           cell.vertex<dim>(cell.face_to_cell_vertices(face, 0, 1));
  }

  /// @return the point of the reference cell that has a parameter on a face, in the convention of
  /// deal.II's QProjector: on hypercubes the parameters follow the normal direction cyclically, on
  /// simplices they are along the edges from the first vertex of the face.
  /// @param cell the reference cell
  /// @param face number of the face
  /// @param xi parameter in [0,1]^(dim-1), or in the reference simplex
  template <int dim>
  dealii::Point<dim>
  unit_point(const dealii::ReferenceCell  &cell,
             const unsigned int            face,
             const dealii::Point<dim - 1> &xi)
  {
    dealii::Point<dim> p;
    if (cell.is_hyper_cube())
      {
        p[face / 2] = face % 2;
        for (unsigned int d = 0; d < dim - 1; ++d)
          p[(face / 2 + 1 + d) % dim] = xi[d];
        return p;
      }
    p = cell.vertex<dim>(cell.face_to_cell_vertices(face, 0, 1));
    for (unsigned int d = 0; d < dim - 1; ++d)
      p += xi[d] * face_direction<dim>(cell, face, d);
    return p;
  }

  /// @return the parameter of a point on a face, the inverse of unit_point().
  /// @param cell the reference cell
  /// @param face number of the face
  /// @param p point of the reference cell
  template <int dim>
  dealii::Point<dim - 1>
  face_parameter(const dealii::ReferenceCell &cell,
                 const unsigned int           face,
                 const dealii::Point<dim>    &p)
  {
    dealii::Point<dim - 1> xi;
    for (unsigned int d = 0; d < dim - 1; ++d)
      // On simplices the parameters are barycentric coordinates.
      xi[d] = cell.is_hyper_cube() ?
                p[(face / 2 + 1 + d) % dim] :
                cell.d_linear_shape_function(p, cell.face_to_cell_vertices(face, d + 1, 1));
    return xi;
  }

  /// @return whether a point of the reference cell is on a face, up to rounding.
  /// @param cell the reference cell
  /// @param face number of the face
  /// @param p point of the reference cell
  template <int dim>
  bool
  is_on_face(const dealii::ReferenceCell &cell,
             const unsigned int           face,
             const dealii::Point<dim>    &p)
  {
    return unit_point<dim>(cell, face, face_parameter<dim>(cell, face, p)).distance(p) < 1e-10;
  }

  /// @return the nearest point of the reference cell; of a simplex a point that is as near as the
  /// nearest one up to a factor, with the negative barycentric coordinates set to zero.
  /// @param cell the reference cell
  /// @param p any point
  template <int dim>
  dealii::Point<dim>
  nearest_in_cell(const dealii::ReferenceCell &cell, const dealii::Point<dim> &p)
  {
    if (cell.is_hyper_cube())
      return dealii::GeometryInfo<dim>::project_to_unit_cell(p);
    dealii::Point<dim> result;
    double             sum = std::max(0., cell.d_linear_shape_function(p, 0));
    for (unsigned int d = 0; d < dim; ++d)
      {
        result[d] = std::max(0., p[d]);
        sum += result[d];
      }
    return dealii::Point<dim>(result / sum);
  }

  /// @return a direction in the reference cell from the middle of a face to the inside. On
  /// hypercubes it is the normal.
  /// @param cell the reference cell
  /// @param face number of the face
  template <int dim>
  dealii::Tensor<1, dim>
  inward_direction(const dealii::ReferenceCell &cell, const unsigned int face)
  {
    if (cell.is_hyper_cube())
      return (face % 2 == 0 ? 1. : -1.) * dealii::Point<dim>::unit_vector(face / 2);
    dealii::Tensor<1, dim> middle_of_face;
    for (unsigned int v = 0; v < dim; ++v)
      middle_of_face += cell.vertex<dim>(cell.face_to_cell_vertices(face, v, 1)) / double(dim);
    return cell.barycenter<dim>() - middle_of_face;
  }

  /// @return whether a face is a triangle.
  /// @param shape its reference cell
  inline bool
  is_triangle(const dealii::ReferenceCell &shape)
  {
    return shape == dealii::ReferenceCells::Triangle;
  }

  /// @return the reference cell of the faces of a cell, which are all alike.
  /// @param cell a hypercube or a simplex
  inline dealii::ReferenceCell
  shape_of_faces(const dealii::ReferenceCell &cell)
  {
    return cell.face_reference_cell(0);
  }

  /// @return the degree of the geometry of a cell and its faces: simplices are curved by parabolas
  /// at most.
  /// @param cell a hypercube or a simplex
  /// @param degree of hypercubes
  inline unsigned int
  geometry_degree_of(const dealii::ReferenceCell &cell, const unsigned int degree)
  {
    return cell.is_simplex() ? std::min(degree, 2u) : degree;
  }

  /// @return coordinates on the face in which distances do not depend on the numbering of vertices:
  /// the parameters, or on triangles those of an equilateral one.
  /// @param shape reference cell of the face
  /// @param xi parameter
  template <int n>
  dealii::Point<n>
  isotropic_coordinates(const dealii::ReferenceCell &shape, const dealii::Point<n> &xi)
  {
    dealii::Point<n> result = xi;
    if constexpr (n == 2)
      if (is_triangle(shape))
        {
          result[0] += xi[1] / 2;
          result[1] *= 0.866025403784438647; // sqrt(3)/2
        }
    return result;
  }

  /// @return the parameters of the two ends of a side of a face in space. Sides are numbered as
  /// the faces of its reference cell: on quadrilaterals side 2 d + (0 or 1) is that where the
  /// parameter d is 0 or 1, on triangles sides follow the vertices around.
  /// @param shape reference cell of the face
  /// @param side its number
  template <int dim>
  std::array<dealii::Point<dim - 1>, 2>
  ends_of_side(const dealii::ReferenceCell &shape, const unsigned int side)
  {
    const auto end = [&](const unsigned int i) {
      return shape.vertex<dim - 1>(shape.face_to_cell_vertices(side, i, 1));
    };
    return {{end(0), end(1)}};
  }

  /// Call visit(i, j) for the numbers along the parameters of all nodes of a lattice, see
  /// face_lattice(); j = 0 on lines.
  template <typename Visit>
  void
  for_each_lattice_node(const dealii::ReferenceCell &shape,
                        const unsigned int           k,
                        const Visit                 &visit)
  {
    for (unsigned int j = 0; j <= (shape.get_dimension() == 2 ? k : 0); ++j)
      for (unsigned int i = 0; i <= (is_triangle(shape) ? k - j : k); ++i)
        visit(i, j);
  }

  /// @return the parameters of the equidistant nodes of a face of degree k, with the first
  /// coordinate running fastest: (k+1)^(dim-1), of a triangle (k+1)(k+2)/2.
  /// @param shape reference cell of the face
  /// @param k degree, at least 1
  template <int dim>
  std::vector<dealii::Point<dim - 1>>
  face_lattice(const dealii::ReferenceCell &shape, const unsigned int k)
  {
    std::vector<dealii::Point<dim - 1>> points;
    for_each_lattice_node(shape, k, [&](const unsigned int i, const unsigned int j) {
      dealii::Point<dim - 1> xi;
      xi[dim - 2] = double(j) / k;
      xi[0]       = double(i) / k;
      points.push_back(xi);
    });
    return points;
  }

  /// @return the values at every n-th node of a lattice, in each direction.
  /// @param shape reference cell of the face
  /// @param values at the nodes of a lattice
  /// @param k its degree, a multiple of n; with n = k the values at the corners are left
  /// @param n step
  template <typename Value>
  std::vector<Value>
  every_nth_of_lattice(const dealii::ReferenceCell &shape,
                       const std::vector<Value>    &values,
                       const unsigned int           k,
                       const unsigned int           n)
  {
    std::vector<Value> result;
    auto               value = values.begin();
    for_each_lattice_node(shape, k, [&](const unsigned int i, const unsigned int j) {
      if (i % n == 0 && j % n == 0)
        result.push_back(*value);
      ++value;
    });
    return result;
  }

  /// @return the reference cell of a face by the number of nodes of its lattice.
  /// @param dim that of the cell
  /// @param k degree
  /// @param n_nodes (k+1)^(dim-1), or (k+1)(k+2)/2 for a triangle
  inline dealii::ReferenceCell
  shape_of_lattice(const unsigned int dim, const unsigned int k, const unsigned int n_nodes)
  {
    return dim == 2                     ? dealii::ReferenceCells::Line :
           n_nodes == (k + 1) * (k + 1) ? dealii::ReferenceCells::Quadrilateral :
                                          dealii::ReferenceCells::Triangle;
  }
} // namespace Signorini
