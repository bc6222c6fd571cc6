// SPDX-License-Identifier: Apache-2.0
#include "solid/assembly.h"

#include "linear_algebra/sparsity_pattern.h"
#include "solid/cell_nodes.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  StiffnessAssembly<dim>::StiffnessAssembly(const Mesh<dim>                 &mesh,
                                            const std::vector<Material>     &materials,
                                            const Model                      model,
                                            const DoFHandler<dim>           &dofs,
                                            const hp::FECollection<dim>     &elements,
                                            const AffineConstraints<double> &constraints,
                                            const IndexSet                  &owned,
                                            const IndexSet                  &relevant)
    : mesh(mesh)
    , materials(materials)
    , model(model)
    , dofs(dofs)
    , elements(elements)
    , constraints(constraints)
    , owned(owned)
    , relevant(relevant)
  {}



  // The cells that `takes` selects, with the matrices of linear elasticity.
  template <int dim>
  void
  StiffnessAssembly<dim>::assemble(LA::SparseMatrix                        &K,
                                   const std::function<bool(const Cell &)> &takes) const
  {
    StiffnessKernel<dim> kernel(mesh, elements, model);
    assemble(K, takes, [&](const Cell &cell, FullMatrix<double> &cell_matrix) {
      kernel.assemble(cell, materials[cell->material_id()], cell_matrix);
    });
  }



  template <int dim>
  void
  StiffnessAssembly<dim>::assemble(
    LA::SparseMatrix                                              &K,
    const std::function<bool(const Cell &)>                       &takes,
    const std::function<void(const Cell &, FullMatrix<double> &)> &matrix_of) const
  {
    // Pattern of the selected cells with constraints eliminated, and the diagonal of all owned
    // degrees of freedom.
    LA::SparsityPattern                  pattern(owned, owned, relevant, mesh.communicator());
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned() && takes(cell))
        {
          read_indices<dim>(cell, indices);
          constraints.add_entries_local_to_global(indices, pattern, false);
        }
    for (const auto i : owned)
      pattern.add(i, i);
    pattern.compress();
    K.reinit(pattern);

    // Cell matrices are distributed with the constraints: K = C^T K_cells C, constrained rows
    // diagonal.
    FullMatrix<double> cell_matrix;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned() && takes(cell))
        {
          matrix_of(cell, cell_matrix);
          read_indices<dim>(cell, indices);
          constraints.distribute_local_to_global(cell_matrix, indices, K);
        }
    K.compress(VectorOperation::add);
  }



  template class StiffnessAssembly<2>;
  template class StiffnessAssembly<3>;
} // namespace Signorini
