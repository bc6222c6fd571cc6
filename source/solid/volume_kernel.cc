// SPDX-License-Identifier: Apache-2.0
#include "solid/volume_kernel.h"

#include "solid/gradient_at_point.h"
#include "solid/scalar_elements.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  VolumeKernel<dim>::VolumeKernel(const Elasticity<dim> &elasticity)
    : elasticity(elasticity)
    , elements(scalar_elements(elasticity.finite_elements()))
    , all_values(elasticity.mesh().mappings(),
                 elements,
                 gauss_rules(elasticity.finite_elements(), 1),
                 update_values | update_gradients | update_JxW_values | update_quadrature_points)
    , all_dofs(dofs_of_nodes(elasticity.finite_elements()))
  {}



  // Rows of the volume constraint (doc/theory, (6.17)): int phi_k theta_v dV and its derivative
  // B_m, with theta_v = tr(eps - eps_T) at small strain or ln J at finite strain, whose derivative
  // is tr(Grad w F^-1).
  template <int dim>
  bool
  VolumeKernel<dim>::assemble(const Cell           &cell,
                              const Vector<double> &u,
                              Vector<double>       &changes,
                              FullMatrix<double>   *slopes)
  {
    constexpr unsigned int n_functions = VolumetricStress<dim>::functions_per_cell;
    const auto             index       = cell->active_fe_index();
    all_values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell),
                      index,
                      0,
                      index);
    const FEValues<dim>             &values           = all_values.get_present_fe_values();
    const std::vector<unsigned int> &dofs             = all_dofs[index];
    const unsigned int               n_nodes          = dofs.size() / dim;
    const Model                      model            = elasticity.model();
    const bool                       is_finite_strain = elasticity.is_finite_strain(),
               has_hoop                               = model == Model::axisymmetric,
               expands = elasticity.thermal().expands(cell->material_id());
    changes.reinit(n_functions);
    if (slopes)
      slopes->reinit(n_functions, dofs.size());
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim>  &x = values.quadrature_point(q);
        const Tensor<2, 3> F = gradient_at_point(model, values, dofs, q, u);
        // Small strain: tr(F) - 3 = tr(Grad u), including the hoop strain. Its derivative is the
        // divergence, with the unit tensor in place of F^-1.
        double       volumetric_strain = trace(F) - 3;
        Tensor<2, 3> by_gradient       = unit_symmetric_tensor<3>(); // [derivative][component]
        if (is_finite_strain)
          {
            const double J = determinant(F);
            // An inverted point has no logarithm; the caller shortens its step. The negated
            // comparison includes NaN.
            if (!(J > 0))
              return false;
            volumetric_strain = std::log(J);
            if (expands)
              volumetric_strain -= std::log(elasticity.thermal().volume_ratio(*cell, x));
            by_gradient = invert(F);
          }
        else if (expands)
          {
            const Tensor<1, 3> strain = elasticity.thermal().strain(*cell, x);
            volumetric_strain -= strain[0] + strain[1] + strain[2];
          }
        const auto   phi    = elasticity.volumetric_stress().functions(*cell, x);
        const double weight = values.JxW(q) * measure(model, x);
        for (unsigned int k = 0; k < n_functions; ++k)
          changes(k) += weight * phi[k] * volumetric_strain;
        if (!slopes)
          continue;
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int a = 0; a < dim; ++a)
            {
              // tr(Grad w F^-1) for w = N_i e_a: sum_d dN_i/dX_d (F^-1)_da.
              double slope = 0;
              for (unsigned int d = 0; d < dim; ++d)
                slope += values.shape_grad(i, q)[d] * by_gradient[d][a];
              if (has_hoop && a == 0)
                slope += values.shape_value(i, q) / x[0] * by_gradient[2][2];
              for (unsigned int k = 0; k < n_functions; ++k)
                (*slopes)(k, dofs[i * dim + a]) += weight * phi[k] * slope;
            }
      }
    return true;
  }



  template class VolumeKernel<2>;
  template class VolumeKernel<3>;
} // namespace Signorini
