// SPDX-License-Identifier: Apache-2.0
#include "fields/point_state.h"

#include "solid/cell_nodes.h"

namespace Signorini
{
  using namespace dealii;

  void
  PointDerivative::compress()
  {
    of_displacement.compress(VectorOperation::add);
    if (of_volumetric_stress.size() > 0)
      of_volumetric_stress.compress(VectorOperation::add);
  }



  template <int dim>
  PointState<dim>::PointState(const Elasticity<dim> &elasticity, const LA::Vector &displacement)
    : elasticity(elasticity)
    , displacement(elasticity.with_ghosts(displacement))
  {}



  // One point at a time, as there are few: each has shape functions of its own.
  template <int dim>
  void
  PointState<dim>::evaluate(const Cell &there, const Point<dim> &unit, const Point<dim> &x)
  {
    const FEValuesExtractors::Vector u(0);
    cell   = there;
    place  = x;
    values = std::make_unique<FEValues<dim>>(elasticity.mesh().mapping(),
                                             elasticity.finite_elements()[cell->active_fe_index()],
                                             Quadrature<dim>(unit),
                                             update_values | update_gradients);
    values->reinit(cell);
    std::vector<Tensor<1, dim>> value(1);
    std::vector<Tensor<2, dim>> gradient(1);
    (*values)[u].get_function_values(displacement, value);
    (*values)[u].get_function_gradients(displacement, gradient);
    state = stress_state(elasticity, *cell, gradient[0], value[0], place);
  }



  template <int dim>
  Tensor<2, dim>
  PointState<dim>::gradient() const
  {
    std::vector<Tensor<2, dim>> result(1);
    (*values)[FEValuesExtractors::Vector(0)].get_function_gradients(displacement, result);
    return result[0];
  }



  // sigma = P F^T/J, as the results have it; at small strain F is the unit tensor.
  template <int dim>
  SymmetricTensor<2, 3>
  PointState<dim>::stress() const
  {
    return symmetrize(state.stress * transpose(state.F)) / determinant(state.F);
  }



  template <int dim>
  void
  PointState<dim>::add_derivative(const double                 weight,
                                  const Tensor<1, dim>        &of_displacement,
                                  const SymmetricTensor<2, 3> &of_stress,
                                  PointDerivative             &sum) const
  {
    const auto                          &volumetric = elasticity.volumetric_stress();
    const FEValuesExtractors::Vector     u(0);
    std::vector<types::global_dof_index> indices;
    read_indices<dim>(cell, indices);
    Vector<double> weights(indices.size());
    for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const Tensor<1, dim> value = (*values)[u].value(i, 0);
        const Tensor<2, 3>   G =
          gradient_of_change(elasticity.model(), (*values)[u].gradient(i, 0), value, place);
        weights[i] =
          weight * (of_displacement * value + of_stress * state.change_of_cauchy_stress(G, 0));
      }
    elasticity.constraints().distribute_local_to_global(weights, indices, sum.of_displacement);
    if (!state.is_mixed)
      return;
    const auto phi = volumetric.functions(*cell, place);
    for (unsigned int i = 0; i < phi.size(); ++i)
      sum.of_volumetric_stress(volumetric.indices(*cell)[i]) +=
        weight * (of_stress * state.change_of_cauchy_stress(Tensor<2, 3>(), phi[i]));
  }



  template class PointState<2>;
  template class PointState<3>;
} // namespace Signorini
