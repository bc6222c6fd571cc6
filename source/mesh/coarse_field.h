// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria_description.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// A scalar on the coarse cells of a mesh, given at their vertices and multilinear between: what
  /// a mesh file says of its nodes. Refined cells have what the coarse ones say. Bodies without one
  /// take no part.
  template <int dim>
  class CoarseField
  {
  public:
    /// The next cells of the mesh, those of a body. @param values at the vertices that the cells
    /// refer to; empty: none
    void
    append(const std::vector<dealii::CellData<dim>> &cells, const std::vector<double> &values);

    /// The ids by which the mesh knows its coarse cells; without, their order.
    void
    number(const std::vector<dealii::types::coarse_cell_id> &ids);

    /// At a point of the reference cell; not a number if the cell's body has no field.
    double
    value(const dealii::CellId &cell, dealii::Point<dim> unit_point) const;

  private:
    using Corners = std::array<double, 1 << dim>;
    std::vector<std::pair<unsigned int, std::vector<Corners>>> blocks; ///< first cell, of each cell
    unsigned int                                               n_cells = 0;
    std::vector<unsigned int>                                  index_of_id;
  };
} // namespace Signorini
