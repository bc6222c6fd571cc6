// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_values.h>

#include <vector>

namespace Signorini
{
  /// Read the degrees of freedom of a cell, of any element. @param indices resized
  template <int dim>
  void
  read_indices(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
               std::vector<dealii::types::global_dof_index>                 &indices)
  {
    indices.resize(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(indices);
  }

  /// The positions of the nodes of a cell.
  template <int dim>
  class CellNodes
  {
  public:
    /// @param elements the elements of cells, by active FE index
    CellNodes(const Mesh<dim> &mesh, const dealii::hp::FECollection<dim> &elements);

    /// One point for each degree of freedom of the cell; valid until the next call.
    const std::vector<dealii::Point<dim>> &
    operator()(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell);

  private:
    dealii::hp::FEValues<dim> values;
  };
} // namespace Signorini
