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

    /// The moments of the tangents of the points of a tetrahedron of degree 2.
    CellTangents
    moments_of(const CellTangents &points)
    {
      using Tables = SimplexTables<double, 2>;
      static const Tables tables;
      CellTangents        result(Tables::n_moments, CellTangent{});
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int b = 0; b <= a; ++b)
          for (unsigned int k = 0; k < n_tangent_numbers; ++k)
            {
              double sum = 0;
              for (unsigned int q = 0; q < points.size(); ++q)
                sum += tables.moment_factor(q, a, b) * points[q][k];
              result[Tables::moment(a, b)][k] = sum;
            }
      return result;
    }

    /// The integral of a tangent over its tetrahedron from its moments: the functions of the
    /// vertices add up to one.
    CellTangent
    sum_of_moments(const CellTangent *moments)
    {
      CellTangent result{};
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int b = 0; b <= a; ++b)
          for (unsigned int k = 0; k < n_tangent_numbers; ++k)
            result[k] += (a == b ? 1 : 2) * moments[SimplexTables<double, 2>::moment(a, b)][k];
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
        cells.tangents.reserve(std::size_t(cells.size()) * cells.tangents_per_cell());
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
          if (cells.are_tetrahedra && cells.degree == 1)
            points = {sum_of(points.data(), points.size())};
          else if (cells.are_tetrahedra)
            points = moments_of(points);
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

    // Weights are in the tangents, so that the integral over the cell is the sum over its points.
    for (KernelCells &cells : space.cells)
      {
        const std::size_t n = cells.tangents_per_cell();
        CellTangents      sums;
        for (unsigned int cell = 0; cell < cells.size(); ++cell)
          sums.push_back(cells.are_tetrahedra && n > 1 ? sum_of_moments(&cells.tangents[cell * n]) :
                                                         sum_of(&cells.tangents[cell * n], n));
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
