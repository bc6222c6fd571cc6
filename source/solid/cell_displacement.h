// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <deal.II/hp/fe_values.h>

#include <vector>

namespace Signorini
{
  /// The displacement and its gradient at the points of a quadrature rule in one cell after the
  /// other.
  template <int dim>
  class CellDisplacement
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// @param elasticity the bodies
    /// @param displacement with ghost values, to which the object refers
    /// @param rules of the elements, in their order
    CellDisplacement(const Elasticity<dim>              &elasticity,
                     const LA::Vector                   &displacement,
                     const dealii::hp::QCollection<dim> &rules)
      : displacement(displacement)
      , all_values(elasticity.mesh().mappings(),
                   elasticity.finite_elements(),
                   rules,
                   dealii::update_values | dealii::update_gradients |
                     dealii::update_quadrature_points | dealii::update_JxW_values)
    {}

    /// Evaluate the displacement in a cell.
    /// @return the shape functions there, with points and weights
    const dealii::FEValues<dim> &
    reinit(const Cell &cell)
    {
      const dealii::FEValuesExtractors::Vector vector(0);
      all_values.reinit(cell);
      const dealii::FEValues<dim> &values = all_values.get_present_fe_values();
      u.resize(values.n_quadrature_points);
      gradient.resize(values.n_quadrature_points);
      // The elements of distributed vectors are read once, since finding them takes time.
      of_cell.resize(values.dofs_per_cell);
      cell->get_dof_values(displacement, of_cell.begin(), of_cell.end());
      values[vector].get_function_values_from_local_dof_values(of_cell, u);
      values[vector].get_function_gradients_from_local_dof_values(of_cell, gradient);
      return values;
    }

    /// The displacement [length], and its gradient, at each point.
    std::vector<dealii::Tensor<1, dim>> u;
    std::vector<dealii::Tensor<2, dim>> gradient;

  private:
    const LA::Vector         &displacement;
    dealii::hp::FEValues<dim> all_values;
    std::vector<double>       of_cell;
  };
} // namespace Signorini
