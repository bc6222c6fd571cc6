// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/face_parameter.h"
#include "mesh_import/mesh_file.h"

#include <deal.II/base/point.h>
#include <deal.II/grid/reference_cell.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace Signorini
{
  /// The shape that cells of a body have unless they are simplices: quadrilaterals in 2D, hexahedra
  /// in 3D.
  template <int dim>
  constexpr MeshFile::Shape cell_shape =
    dim == 2 ? MeshFile::Shape::quadrilateral : MeshFile::Shape::hexahedron;

  /// The shape of simplices: triangles in 2D, tetrahedra in 3D.
  template <int dim>
  constexpr MeshFile::Shape simplex_shape =
    dim == 2 ? MeshFile::Shape::triangle : MeshFile::Shape::tetrahedron;

  /// @return the reference cell of a cell.
  template <int dim>
  dealii::ReferenceCell
  reference_cell_of(const dealii::CellData<dim> &cell)
  {
    return dealii::ReferenceCell::n_vertices_to_type(dim, cell.vertices.size());
  }

  /// @return the same nodes in ascending order, so that sets of nodes can be compared.
  /// @param nodes indices in any order
  inline std::vector<unsigned int>
  sorted(std::vector<unsigned int> nodes)
  {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  /// @return the nodes of a face of a cell, in deal.II's order.
  /// @param cell the cell
  /// @param face its number
  template <int dim>
  std::vector<unsigned int>
  face_nodes(const dealii::CellData<dim> &cell, const unsigned int face)
  {
    const auto                reference = reference_cell_of(cell);
    std::vector<unsigned int> nodes;
    for (const unsigned int v : reference.face_reference_cell(face).vertex_indices())
      nodes.push_back(cell.vertices[reference.face_to_cell_vertices(face, v, 1)]);
    return nodes;
  }

  /// @return the ends of the lines of a cell.
  /// @param cell the cell
  template <int dim>
  std::vector<std::pair<unsigned int, unsigned int>>
  lines_of(const dealii::CellData<dim> &cell)
  {
    const auto                                         reference = reference_cell_of(cell);
    std::vector<std::pair<unsigned int, unsigned int>> result;
    for (unsigned int l = 0; l < reference.n_lines(); ++l)
      {
        const auto ends = ends_of_line(reference, l);
        result.emplace_back(cell.vertices[ends[0]], cell.vertices[ends[1]]);
      }
    return result;
  }

  /// @return the coordinates of a point for messages, such as "(1 2 3)".
  /// @param p the point
  template <int dim>
  std::string
  text_of(const dealii::Point<dim> &p)
  {
    std::ostringstream out;
    out << '(' << p << ')';
    return out.str();
  }
} // namespace Signorini
