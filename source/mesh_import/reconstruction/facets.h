// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/cell_size.h"
#include "geometry/manifolds.h"
#include "mesh_import/cells.h"

#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <map>

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

  /// The boundary faces of a triangulation by their sorted vertices, with the depth of their
  /// cells, and the cells at each vertex of these faces.
  template <int dim>
  struct FacesByVertices
  {
    using Face = typename dealii::Triangulation<dim>::face_iterator;
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    std::map<std::vector<unsigned int>, std::pair<double, Face>> faces;
    std::map<unsigned int, std::vector<Cell>>                    cells;

    explicit FacesByVertices(const dealii::Triangulation<dim> &triangulation)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (const Face face = cell->face(f); face->at_boundary())
            {
              std::vector<unsigned int> vertices;
              for (const unsigned int v : face->vertex_indices())
                {
                  vertices.push_back(face->vertex_index(v));
                  cells[face->vertex_index(v)];
                }
              // The corner of a simplex opposite to the face is farther from it than the mean
              // depth.
              const double factor     = cell->reference_cell().is_simplex() ? dim : 1;
              faces[sorted(vertices)] = {factor * depth_behind(cell, f), face};
            }
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          if (const auto found = cells.find(cell->vertex_index(v)); found != cells.end())
            found->second.push_back(cell);
    }

    /// @return the depth [length] of the cell behind a boundary face, and the face.
    /// @param face with vertices of the triangulation in any order
    const std::pair<double, Face> &
    at(const dealii::CellData<dim - 1> &face) const
    {
      return faces.at(sorted(face.vertices));
    }
  };



  /// @return whether a cell is so thin (sagitta above a third of its depth) that the curved
  /// surface would come close to the opposite side of the cell.
  inline bool
  is_thin(const double sagitta, const double depth)
  {
    constexpr double thin = 1. / 3; // sagitta by depth
    return sagitta > thin * depth;
  }



  /// @return the lines of a face as sorted vertices: in 2D the face itself.
  template <int dim>
  std::vector<std::vector<unsigned int>>
  lines_of(const std::vector<unsigned int> &vertices)
  {
    if constexpr (dim == 2)
      return {sorted(vertices)};
    else
      return rims_of<dim>(vertices);
  }



  /// What curved faces move.
  template <int dim>
  struct Moved
  {
    /// The new positions of vertices that were inserted.
    std::map<unsigned int, dealii::Point<dim>> vertices;
    /// The points in the middle of lines, by the sorted vertices at their ends.
    std::map<std::vector<unsigned int>, dealii::Point<dim>> middles;
  };

  /// @return whether a cell is inverted by what is moved: a simplex by its lines, another cell by
  /// its vertices.
  template <int dim>
  bool
  is_inverted(const typename FacesByVertices<dim>::Cell &cell, const Moved<dim> &moved)
  {
    std::vector<dealii::Point<dim>> nodes;
    bool                            is_changed = false;
    const auto                      add = [&](const auto &list, const auto &key, const auto &old) {
      const auto found = list.find(key);
      nodes.push_back(found == list.end() ? old : found->second);
      is_changed = is_changed || found != list.end();
    };
    for (const unsigned int v : cell->vertex_indices())
      add(moved.vertices, cell->vertex_index(v), cell->vertex(v));
    if (cell->reference_cell().is_simplex())
      {
        for (const unsigned int l : cell->line_indices())
          add(moved.middles,
              sorted({cell->line(l)->vertex_index(0), cell->line(l)->vertex_index(1)}),
              cell->line(l)->center());
        return is_changed && is_inverted_simplex(nodes);
      }
    if (!is_changed)
      return false;
    const auto volumes = determinants_at_corners(nodes);
    return std::any_of(volumes.begin(), volumes.end(), [](const double v) { return !(v > 0); });
  }

  /// @return whether a cell at a vertex of a face is inverted by what is moved.
  template <int dim>
  bool
  inverts_cells(const typename FacesByVertices<dim>::Face &face,
                const Moved<dim>                          &moved,
                const FacesByVertices<dim>                &by_vertices)
  {
    for (const unsigned int v : face->vertex_indices())
      for (const auto &cell : by_vertices.cells.at(face->vertex_index(v)))
        if (is_inverted<dim>(cell, moved))
          return true;
    return false;
  }
} // namespace Signorini
