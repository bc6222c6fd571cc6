// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/tangent_stiffness.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <typename Number>
    void
    set(std::optional<CellOperator<Number>> &cells, const CellSpace &space)
    {
      if (cells)
        cells->update(space);
      else
        cells.emplace(space);
    }
  } // namespace



  TangentStiffness::TangentStiffness(const Elasticity<3> &elasticity, DeformationKernel<3> &kernel)
    : CellStiffness(elasticity)
    , kernel(kernel)
    , space(bare_cell_space(elasticity))
  {
    evaluate(elasticity.with_ghosts(elasticity.zero_vector()));
    update();
  }



  std::string
  TangentStiffness::evaluate(const LA::Vector &u)
  {
    next = u;
    for (KernelCells &cells : space.cells)
      {
        cells.tangents.clear();
        cells.tangents.reserve(std::size_t(cells.size()) * cells.nodes_per_cell());
      }
    Vector<double> values;
    CellTangents   points;
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_values(next, values);
          if (!kernel.tangents(cell, elasticity.material(cell->material_id()), values, points))
            return elasticity.mesh().body_name(elasticity.mesh().body(cell));
          CellTangents &tangents = space.cells[cell->active_fe_index()].tangents;
          tangents.insert(tangents.end(), points.begin(), points.end());
        }
    return {};
  }



  void
  TangentStiffness::update()
  {
    linearisation_point  = std::move(next);
    space.diagonal_terms = elasticity.diagonal_terms();
    set(in_double_precision, space);

    for (KernelCells &cells : space.cells)
      {
        const std::size_t n_points = cells.nodes_per_cell();
        CellTangents      sums(cells.size(), CellTangent{});
        for (std::size_t point = 0; point < cells.tangents.size(); ++point)
          for (unsigned int k = 0; k < n_tangent_numbers; ++k)
            sums[point / n_points][k] += cells.tangents[point][k];
        cells.tangents = std::move(sums);
      }
    set(in_single_precision, space);

    means.resize(elasticity.mesh().triangulation().n_active_cells());
    std::vector<std::size_t> n_before(space.cells.size(), 0);
    for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int e             = cell->active_fe_index();
          means[cell->active_cell_index()] = space.cells[e].tangents[n_before[e]++];
        }
    for (KernelCells &cells : space.cells)
      CellTangents().swap(cells.tangents);
    has_changed();
  }



  void
  TangentStiffness::assemble(LA::SparseMatrix                        &K,
                             const std::function<bool(const Cell &)> &takes) const
  {
    Vector<double> values, forces;
    elasticity.assembly().assemble(K, takes, [&](const Cell &cell, FullMatrix<double> &tangent) {
      values.reinit(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_values(linearisation_point, values);
      kernel.assemble(cell, elasticity.material(cell->material_id()), values, forces, &tangent);
    });
  }
} // namespace Signorini
