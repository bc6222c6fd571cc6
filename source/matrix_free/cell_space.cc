// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/cell_space.h"

#include "linear_algebra/diagonal.h"
#include "linear_algebra/sparsity_pattern.h"
#include "matrix_free/cell_matrices.h"
#include "solid/cell_nodes.h"

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr int dim = 3;

    /// The nodes of an element in the order of kernels: lexicographic in hexahedra, in tetrahedra
    /// that of deal.II.
    std::vector<unsigned int>
    ordered_nodes(const FiniteElement<dim> &fe)
    {
      // deal.II numbers the nodes of a cell by vertices, lines, quads and interior; kernels of
      // hexahedra use tensor products and need them line by line.
      if (const auto *scalar = dynamic_cast<const FE_Q<dim> *>(&fe.base_element(0)))
        return scalar->get_poly_space_numbering_inverse();
      std::vector<unsigned int> result(fe.base_element(0).n_dofs_per_cell());
      std::iota(result.begin(), result.end(), 0);
      return result;
    }

    /// Of the degrees of freedom of a cell, the first components of its nodes, in the order of
    /// kernels. Throws if the components of a node are not consecutive.
    std::vector<unsigned int>
    first_components(const FiniteElement<dim> &fe)
    {
      // Kernels access a node by its first degree of freedom only, therefore its components have to
      // be consecutive.
      std::vector<unsigned int> result;
      for (const unsigned int node : ordered_nodes(fe))
        {
          result.push_back(fe.component_to_system_index(0, node));
          for (unsigned int c = 1; c < dim; ++c)
            AssertThrow(fe.component_to_system_index(c, node) == result.back() + c,
                        ExcInternalError("Components of a node are not one after the other."));
        }
      return result;
    }

    /// Call visit(cell) for the locally owned cells with a given active FE index.
    template <typename Visitor>
    void
    for_cells(const Elasticity<dim> &elasticity, const unsigned int element, const Visitor &visit)
    {
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->active_fe_index() == element)
          visit(cell);
    }

    /// The locally owned cells with a given active FE index: degree and nodes.
    KernelCells
    cells_of(const Elasticity<dim> &elasticity, const unsigned int element)
    {
      const FiniteElement<dim>            &fe    = elasticity.finite_elements()[element];
      const std::vector<unsigned int>      nodes = first_components(fe);
      KernelCells                          cells;
      std::vector<types::global_dof_index> indices;
      cells.degree         = fe.degree;
      cells.are_tetrahedra = fe.reference_cell().is_simplex();
      for_cells(elasticity, element, [&](const auto &cell) {
        read_indices<dim>(cell, indices);
        for (const unsigned int i : nodes)
          cells.nodes.push_back(indices[i]);
      });
      return cells;
    }

    /// Add node positions and Lamé constants of the cells.
    void
    add_materials(const Elasticity<dim> &elasticity, const unsigned int element, KernelCells &cells)
    {
      // Where the mapping places the nodes of the reference cell. FE_Nothing: no shape functions
      // are needed, positions only.
      const FiniteElement<dim> &fe = elasticity.finite_elements()[element];
      std::vector<Point<dim>>   nodes;
      for (const unsigned int node : ordered_nodes(fe))
        nodes.push_back(fe.base_element(0).unit_support_point(node));
      const FE_Nothing<dim> nothing(fe.reference_cell());
      FEValues<dim>         places(elasticity.mesh().mapping(),
                           nothing,
                           Quadrature<dim>(nodes),
                           update_quadrature_points);
      for_cells(elasticity, element, [&](const auto &cell) {
        places.reinit(static_cast<const Triangulation<dim>::cell_iterator &>(cell));
        for (const Point<dim> &x : places.get_quadrature_points())
          cells.points.insert(cells.points.end(), x.begin_raw(), x.end_raw());
        const Material &material = elasticity.material(cell->material_id());
        cells.lambda.push_back(material.lambda());
        cells.mu.push_back(material.mu());
      });
    }
  } // namespace



  // Without geometry and moduli, for kernels with tangents, which contain both.
  CellSpace
  bare_cell_space(const Elasticity<dim> &elasticity)
  {
    CellSpace space;
    space.owned          = elasticity.owned();
    space.comm           = elasticity.mesh().communicator();
    space.diagonal_terms = elasticity.diagonal_terms();
    space.constraints.copy_from(elasticity.constraints());
    // One group of cells for each element, since a kernel is compiled for one degree.
    for (unsigned int e = 0; e < elasticity.finite_elements().size(); ++e)
      space.cells.push_back(cells_of(elasticity, e));
    return space;
  }



  CellSpace
  cell_space(const Elasticity<dim> &elasticity)
  {
    CellSpace space = bare_cell_space(elasticity);
    for (unsigned int e = 0; e < space.cells.size(); ++e)
      add_materials(elasticity, e, space.cells[e]);
    return space;
  }



  namespace
  {
    /// The degrees of freedom of a cell, node by node.
    std::vector<types::global_dof_index>
    dofs_of(const KernelCells &cells, const unsigned int cell)
    {
      const unsigned int                   n = cells.nodes_per_cell();
      std::vector<types::global_dof_index> dofs;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          dofs.push_back(cells.nodes[std::size_t(n) * cell + i] + c);
      return dofs;
    }
  } // namespace



  // Assemble the matrix of a space from the kernel's products with unit vectors, see CellMatrices,
  // for the coarsest levels and preconditioners that need a matrix.
  void
  assemble(const CellSpace &space, LA::SparseMatrix &K)
  {
    std::vector<types::global_dof_index> others; // of other ranks
    const auto                           note = [&](const types::global_dof_index dof) {
      if (!space.owned.is_element(dof))
        others.push_back(dof);
    };
    const auto for_each = [&](const auto &act) {
      for (const KernelCells &cells : space.cells)
        for (unsigned int cell = 0; cell < cells.size(); ++cell)
          act(cells, cell);
    };
    // Indices of other ranks that rows may be written to: degrees of freedom of the cells, and
    // those on which constrained ones of these depend.
    for_each([&](const KernelCells &cells, const unsigned int cell) {
      for (const auto dof : dofs_of(cells, cell))
        {
          note(dof);
          if (const auto *line = space.constraints.get_constraint_entries(dof))
            for (const auto &entry : *line)
              note(entry.first);
        }
    });
    IndexSet relevant = space.owned;
    relevant.add_indices(others.begin(), others.end());
    LA::SparsityPattern pattern(space.owned, space.owned, relevant, space.comm);
    // The pattern, with all diagonal entries: diagonal terms are added to them.
    for_each([&](const KernelCells &cells, const unsigned int cell) {
      space.constraints.add_entries_local_to_global(dofs_of(cells, cell), pattern, false);
    });
    for (const auto i : space.owned)
      pattern.add(i, i);
    pattern.compress();
    K.reinit(pattern);
    // Add the element matrices, with their constraints condensed.
    for (const KernelCells &cells : space.cells)
      {
        // The matrices of all cells of a degree come from products of the kernel with unit vectors,
        // 24 or 81 products altogether, whatever the number of cells is.
        std::vector<unsigned int> all(cells.size());
        std::iota(all.begin(), all.end(), 0);
        const CellMatrices matrices(cells, all);
        for (const unsigned int cell : all)
          space.constraints.distribute_local_to_global(matrices.matrix(cell),
                                                       dofs_of(cells, cell),
                                                       K);
      }
    K.compress(VectorOperation::add);
    LA::add_to_diagonal(K, space.diagonal_terms);
  }
} // namespace Signorini
