// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/grid/tria_description.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// Nodes of cells that are closer to each other than a distance.
  template <int dim>
  class CoincidingNodes
  {
  public:
    /// `distance` 0 stands for 1e-3 of the shortest edge of the cells.
    CoincidingNodes(const std::vector<dealii::CellData<dim>> &cells,
                    const std::vector<dealii::Point<dim>>    &vertices,
                    double                                    distance);

    /// For each vertex the one that shall stand for it: the first of those that coincide.
    std::vector<unsigned int>
    representatives() const;

    /// Throws SceneError with their number and the place of the first where cells are connected
    /// otherwise: there is a crack. Returns what is to be said of those between cells that are not
    /// connected; empty if there are none.
    std::string
    reject_cracks() const;

  private:
    const std::vector<dealii::CellData<dim>>          &cells;
    const std::vector<dealii::Point<dim>>             &vertices;
    std::vector<std::pair<unsigned int, unsigned int>> pairs; ///< the lower number first, in order
  };

  /// Throws SceneError if a node at the boundary lies inside of an edge there, of cells that are
  /// connected elsewhere: neighbours of different sizes that do not share their nodes, and would
  /// come apart. Pieces that touch are none of its business.
  template <int dim>
  void
  reject_hanging_nodes(const std::vector<dealii::CellData<dim>>     &cells,
                       const std::vector<dealii::CellData<dim - 1>> &boundary_faces,
                       const std::vector<dealii::Point<dim>>        &vertices);
} // namespace Signorini
