// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/grid/tria_description.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// Pairs of nodes of a mesh that are closer to each other than a distance. Refers to the cells
  /// and vertices.
  template <int dim>
  class CoincidingNodes
  {
  public:
    /// Find the pairs.
    /// @param cells the mesh; other vertices are ignored
    /// @param vertices to which the cells refer
    /// @param distance [length] up to which nodes coincide; 0 stands for 1e-3 of the shortest edge
    /// of the cells
    CoincidingNodes(const std::vector<dealii::CellData<dim>> &cells,
                    const std::vector<dealii::Point<dim>>    &vertices,
                    double                                    distance);

    /// @return for each vertex the one that replaces it if nodes are merged: the lowest index among
    /// those that coincide, itself for all others.
    std::vector<unsigned int>
    representatives() const;

    /// Throws SceneError if nodes coincide although their cells are connected elsewhere, which is a
    /// crack; with the number of such pairs and the position of the first.
    /// @return a message about coinciding nodes of pieces that are not connected; empty if there
    /// are none
    std::string
    reject_cracks() const;

  private:
    const std::vector<dealii::CellData<dim>>          &cells;
    const std::vector<dealii::Point<dim>>             &vertices;
    std::vector<std::pair<unsigned int, unsigned int>> pairs; ///< the lower number first, in order
  };

  /// Throws SceneError if a node at the boundary lies inside an edge of the boundary of the same
  /// connected piece: cells of different sizes meet there without sharing nodes, and would
  /// separate. Separate pieces that touch are accepted.
  /// @param cells the mesh
  /// @param boundary_faces all faces with one cell only
  /// @param vertices to which both refer
  template <int dim>
  void
  reject_hanging_nodes(const std::vector<dealii::CellData<dim>>     &cells,
                       const std::vector<dealii::CellData<dim - 1>> &boundary_faces,
                       const std::vector<dealii::Point<dim>>        &vertices);
} // namespace Signorini
