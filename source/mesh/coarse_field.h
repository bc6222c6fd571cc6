// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria_description.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// A scalar field that is given at the vertices of coarse cells and multilinear between them,
  /// such as nodal values of a mesh file. On refined cells it is that of the coarse cell. Bodies
  /// may have no field.
  template <int dim>
  class CoarseField
  {
  public:
    /// Append the coarse cells of the next body.
    /// @param cells of the body
    /// @param values at the vertices to which the cells refer; empty: the body has no field
    void
    append(const std::vector<dealii::CellData<dim>> &cells, const std::vector<double> &values);

    /// Assign ids to the coarse cells; before, their order counts.
    /// @param ids one for each coarse cell that has been appended
    void
    number(const std::vector<dealii::types::coarse_cell_id> &ids);

    /// @return the value at a point of a cell; NaN if its body has no field.
    /// @param cell id of the cell, on any level
    /// @param unit_point coordinates in its reference cell
    double
    value(const dealii::CellId &cell, dealii::Point<dim> unit_point) const;

  private:
    using Corners = std::array<double, 1 << dim>; // simplices use the first dim + 1 of them

    /// The field of a body.
    struct Block
    {
      unsigned int          first; // cell
      dealii::ReferenceCell shape;
      /// The values at the corners of the cells.
      std::vector<Corners> cells;
    };
    std::vector<Block>        blocks;
    unsigned int              n_cells = 0;
    std::vector<unsigned int> index_of_id;
  };
} // namespace Signorini
