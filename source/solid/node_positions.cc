// SPDX-License-Identifier: Apache-2.0
#include "solid/node_positions.h"

#include "solid/cell_nodes.h"

namespace Signorini
{
  using namespace dealii;

  // Each node is written from every cell that has it, with the same position.
  template <int dim>
  NodePositions
  node_positions(const Mesh<dim>             &mesh,
                 const DoFHandler<dim>       &dofs,
                 const hp::FECollection<dim> &elements,
                 const IndexSet              &owned)
  {
    const auto    n_mesh = dofs.n_dofs();
    NodePositions result;
    result.dim = dim;
    result.coordinates.resize(owned.n_elements(), 0.);
    result.n_rigid = (owned.size() - n_mesh) / dim;
    if (result.n_rigid > 0 && owned.is_element(n_mesh))
      result.n_own_rigid = result.n_rigid;
    CellNodes<dim>                       nodes_of(mesh, elements);
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const std::vector<Point<dim>> &nodes = nodes_of(cell);
          read_indices<dim>(cell, indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (owned.is_element(indices[i]))
              result.coordinates[owned.index_within_set(indices[i])] =
                nodes[i][cell->get_fe().system_to_component_index(i).first];
        }
    return result;
  }



  template <int dim>
  NodePositions
  node_positions(const Displacements<dim> &displacements)
  {
    return node_positions(displacements.mesh(),
                          displacements.dof_handler(),
                          displacements.finite_elements(),
                          displacements.owned());
  }



  template NodePositions
  node_positions(const Mesh<2> &,
                 const DoFHandler<2> &,
                 const hp::FECollection<2> &,
                 const IndexSet &);
  template NodePositions
  node_positions(const Mesh<3> &,
                 const DoFHandler<3> &,
                 const hp::FECollection<3> &,
                 const IndexSet &);
  template NodePositions
  node_positions(const Displacements<2> &);
  template NodePositions
  node_positions(const Displacements<3> &);
} // namespace Signorini
