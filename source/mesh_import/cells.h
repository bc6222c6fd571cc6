// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh_import/mesh_file.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace Signorini
{
  /// The shape that cells of a body have: quadrilaterals in 2D, hexahedra in 3D.
  template <int dim>
  constexpr MeshFile::Shape cell_shape =
    dim == 2 ? MeshFile::Shape::quadrilateral : MeshFile::Shape::hexahedron;

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
    using Info = dealii::GeometryInfo<dim>;
    std::vector<unsigned int> nodes(Info::vertices_per_face);
    for (unsigned int v = 0; v < nodes.size(); ++v)
      nodes[v] = cell.vertices[Info::face_to_cell_vertices(face, v)];
    return nodes;
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
