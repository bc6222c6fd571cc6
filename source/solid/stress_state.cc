// SPDX-License-Identifier: Apache-2.0
#include "solid/stress_state.h"

#include "solid/stress.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // With P = F S it is G S + F dS, dS = (2 dS/dC) : sym(F^T G) (doc/theory, (6.3)), and q F^-T for
  // the energy m ln J.
  Tensor<2, 3>
  StressState::change_of_stress(const Tensor<2, 3> &G, const double q) const
  {
    if (is_small)
      return Tensor<2, 3>(response.tangent * symmetrize(G) +
                          (is_mixed ? q : 0.) * unit_symmetric_tensor<3>());
    Tensor<2, 3> result =
      G * Tensor<2, 3>(response.stress) +
      F * Tensor<2, 3>(SymmetricTensor<2, 3>(response.tangent * symmetrize(transpose(F) * G)));
    if (is_mixed)
      result += q * transpose(inverse);
    return result;
  }



  double
  StressState::change_of_volume_residual(const Tensor<2, 3> &G, const double q) const
  {
    return is_mixed ? trace(inverse * G) - compliance * q : 0.;
  }



  // sigma = P F^T/J, with dJ = J tr(F^-1 G). In plane stress the thickness changes as well:
  // 2 F_zz dF_zz = dC_zz.
  SymmetricTensor<2, 3>
  StressState::change_of_cauchy_stress(const Tensor<2, 3> &G, const double q) const
  {
    const Tensor<2, 3> of_P = change_of_stress(G, q);
    if (is_small)
      return symmetrize(of_P);
    Tensor<2, 3> of_F = G;
    of_F[2][2] += thickness * symmetrize(transpose(F) * G) / F[2][2];
    return symmetrize(of_P * transpose(F) + stress * transpose(of_F) -
                      trace(inverse * of_F) * stress * transpose(F)) /
           determinant(F);
  }



  namespace
  {
    /// Add the terms of the volumetric stress m to the energy, and the residual of the volume.
    template <int dim>
    void
    add_volume(const Elasticity<dim>   &elasticity,
               const CellAccessor<dim> &cell,
               const Tensor<2, 3>      &total, // deformation gradient with thermal part
               const Point<dim>        &X,
               StressState             &state)
    {
      const double m       = elasticity.volumetric_stress().value(cell, X);
      const bool   expands = elasticity.thermal().expands(cell.material_id());
      double       theta   = 0;
      state.compliance     = elasticity.material(cell.material_id()).bulk_compliance();
      if (state.is_small)
        {
          theta = trace(total) - 3;
          if (expands)
            for (unsigned int d = 0; d < 3; ++d)
              theta -= elasticity.thermal().strain(cell, X)[d];
        }
      else
        {
          theta = std::log(determinant(state.F));
          // The response contains the energy m ln J.
          state.energy -= m * theta;
          if (expands)
            {
              theta -= std::log(elasticity.thermal().volume_ratio(cell, X));
              state.compliance /= elasticity.thermal().volume_ratio(cell, cell.center());
            }
        }
      state.volume_residual = theta - state.compliance * m;
      state.energy += m * theta - m * m * state.compliance / 2;
    }
  } // namespace



  // Linear elasticity has thermal strain and volumetric stress beside its law.
  template <int dim>
  StressState
  stress_state(const Elasticity<dim>   &elasticity,
               const CellAccessor<dim> &cell,
               const Tensor<2, dim>    &gradient,
               const Tensor<1, dim>    &u,
               const Point<dim>        &X)
  {
    std::vector<double> internal;
    const Material     &material = elasticity.material(cell.material_id());
    const MaterialPoint point    = elasticity.material_point(cell, X, internal);
    const Tensor<2, 3>  total    = deformation_gradient(elasticity.model(), gradient, u, X);
    StressState         state;
    Tensor<2, 3>        F = total;
    state.response        = response_at(elasticity.model(), point, F);
    state.is_small        = point.strain_measure == StrainMeasure::small;
    state.is_mixed        = elasticity.volumetric_stress().is_on(cell);
    state.energy          = state.response.energy;
    if (!state.is_small)
      {
        state.F       = F;
        state.inverse = invert(F);
        // The law is asked once more, since its response has the thickness condensed out.
        if (elasticity.model() == Model::plane_stress)
          {
            const auto T = point.at(symmetrize(transpose(F) * F), ResponseOrder::tangent).tangent;
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int l = k; l < dim; ++l)
                state.thickness[k][l] = -T[2][2][k][l] / T[2][2][2][2];
          }
      }
    if (material.constitutive_law)
      state.stress = state.F * Tensor<2, 3>(state.response.stress);
    else
      {
        // The tangent is that of the law, since thermal strain does not depend on u.
        const SymmetricTensor<2, 3> sigma = elasticity.stress(cell, gradient, u, X);
        state.stress                      = Tensor<2, 3>(sigma);
        // The energy of the part that follows from the displacement.
        const SymmetricTensor<2, 3> of_displacement =
          sigma - (state.is_mixed ? elasticity.volumetric_stress().value(cell, X) : 0.) *
                    unit_symmetric_tensor<3>();
        state.energy = of_displacement *
                       (state.is_mixed ? of_displacement / (2 * material.mu()) :
                                         compliance(material, of_displacement)) /
                       2;
      }
    if (state.is_mixed)
      add_volume(elasticity, cell, total, X, state);
    return state;
  }



  template StressState
  stress_state(const Elasticity<2> &,
               const CellAccessor<2> &,
               const Tensor<2, 2> &,
               const Tensor<1, 2> &,
               const Point<2> &);
  template StressState
  stress_state(const Elasticity<3> &,
               const CellAccessor<3> &,
               const Tensor<2, 3> &,
               const Tensor<1, 3> &,
               const Point<3> &);
} // namespace Signorini
