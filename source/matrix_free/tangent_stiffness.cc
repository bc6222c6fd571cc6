// SPDX-License-Identifier: Apache-2.0
#include "matrix_free/tangent_stiffness.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Create an operator, or give an existing one the new tangents; its vectors and exchanges are
    /// kept.
    template <typename Number>
    void
    set(std::optional<CellOperator<Number>> &cells, const CellSpace &space)
    {
      if (cells)
        cells->update(space);
      else
        cells.emplace(space);
    }

    /// The sum of the tangents of n points.
    CellTangent
    sum_of(const CellTangent *points, const std::size_t n)
    {
      CellTangent result{};
      for (std::size_t q = 0; q < n; ++q)
        for (unsigned int k = 0; k < n_tangent_numbers; ++k)
          result[k] += points[q][k];
      return result;
    }
  } // namespace



  // The tangent of the undeformed bodies, so that the operator can be used before the first update.
  TangentStiffness::TangentStiffness(const Elasticity<3> &elasticity, DeformationKernel<3> &kernel)
    : CellStiffness(elasticity)
    , kernel(kernel)
    , space(bare_cell_space(elasticity))
  {
    evaluate(elasticity.with_ghosts(elasticity.zero_vector()));
    update();
  }



  // Tangents at all quadrature points of all cells at displacement u (with ghosts); the operators
  // are set by update(). If a cell is inverted, its body is named and the operators stay as they
  // are. Local.
  std::string
  TangentStiffness::evaluate(const LA::Vector &u)
  {
    next = u;
    for (KernelCells &cells : space.cells)
      {
        cells.tangents.clear();
        cells.tangents.reserve(std::size_t(cells.size()) * cells.points_per_cell());
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
          KernelCells &cells = space.cells[cell->active_fe_index()];
          // Kernels of constant gradients have one point, the integrals have more of them.
          if (cells.points_per_cell() == 1)
            points = {sum_of(points.data(), points.size())};
          cells.tangents.insert(cells.tangents.end(), points.begin(), points.end());
        }
    return {};
  }



  // From the tangents at points: the operator in double precision with all of them, the one in
  // single precision and the coarser levels with the means of the cells. Memory: 45 floats for each
  // point while both exist.
  void
  TangentStiffness::update()
  {
    linearisation_point  = std::move(next);
    space.diagonal_terms = elasticity.diagonal_terms();
    set(in_double_precision, space);

    // Weights are in the tangents, so that the mean over the cell is the sum over its points.
    for (KernelCells &cells : space.cells)
      {
        const std::size_t n_points = cells.points_per_cell();
        CellTangents      sums;
        for (unsigned int cell = 0; cell < cells.size(); ++cell)
          sums.push_back(sum_of(&cells.tangents[cell * n_points], n_points));
        cells.tangents = std::move(sums);
      }
    set(in_single_precision, space);

    // The means by active cell, for the tangents of coarser levels; the cells of each degree are in
    // the order of the mesh.
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



  // Rows or the whole matrix are assembled from cell tangents at the point of the last update.
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
