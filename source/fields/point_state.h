// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/stress_state.h"

#include <deal.II/fe/fe_values.h>

#include <memory>

namespace Signorini
{
  /// Derivatives by the free degrees of freedom of the displacement, and by the coefficients of the
  /// volumetric stress (empty: no body is in displacement-pressure form).
  struct PointDerivative
  {
    /// Zero. @param elasticity whose vectors these are
    template <int dim>
    explicit PointDerivative(const Elasticity<dim> &elasticity)
      : of_displacement(elasticity.zero_vector())
      , of_volumetric_stress(elasticity.volumetric_stress().zero_vector())
    {}

    /// Send what was added for other ranks to them. Collective.
    void
    compress();

    LA::Vector of_displacement, of_volumetric_stress;
  };

  /// Displacement and stress at single points of cells, and their derivatives.
  template <int dim>
  class PointState
  {
  public:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Keeps a reference to elasticity. Collective. @param displacement without ghost values
    PointState(const Elasticity<dim> &elasticity, const LA::Vector &displacement);

    /// Evaluate a point of a locally owned or ghost cell.
    /// @param unit the point in coordinates of the cell
    /// @param x the same in space
    void
    evaluate(const Cell &cell, const dealii::Point<dim> &unit, const dealii::Point<dim> &x);

    /// @return the displacement gradient there.
    dealii::Tensor<2, dim>
    gradient() const;

    /// @return the Cauchy stress there.
    dealii::SymmetricTensor<2, 3>
    stress() const;

    /// Add the derivative of weight (of_displacement . u + of_stress : sigma) there.
    void
    add_derivative(double                               weight,
                   const dealii::Tensor<1, dim>        &of_displacement,
                   const dealii::SymmetricTensor<2, 3> &of_stress,
                   PointDerivative                     &sum) const;

  private:
    const Elasticity<dim> &elasticity;
    const LA::Vector       displacement; ///< with ghosts

    // Of the present point:
    Cell                                   cell;
    dealii::Point<dim>                     place;
    std::unique_ptr<dealii::FEValues<dim>> values;
    StressState                            state;
  };
} // namespace Signorini
