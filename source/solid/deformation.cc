// SPDX-License-Identifier: Apache-2.0
#include "solid/deformation.h"

#include <cmath>
#include <stdexcept>

namespace Signorini
{
  using namespace dealii;

  // Plane models keep F_zz = 1; in plane stress it is only the start of the iteration for the
  // thickness, see response_at().
  template <int dim>
  Tensor<2, 3>
  deformation_gradient(const Model           model,
                       const Tensor<2, dim> &gradient,
                       const Tensor<1, dim> &u,
                       const Point<dim>     &X)
  {
    Tensor<2, 3> F = unit_symmetric_tensor<3>();
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        F[i][j] += gradient[i][j];
    // Hoop stretch 1 + u_r/R; on the axis its limit 1 + du_r/dR.
    if (model == Model::axisymmetric)
      F[2][2] += X[0] > 1e-10 * std::abs(X[1]) ? u[0] / X[0] : gradient[0][0];
    return F;
  }



  namespace
  {
    /// Add the contribution of m ln J to the energy (doc/theory, (6.16)): S = m C^-1. The tangent 2
    /// dS/dC is -2 m P with P_ijkl = (A_ik A_jl + A_il A_jk)/2 and A = C^-1.
    void
    add_volumetric_stress(const double                 m,
                          const SymmetricTensor<2, 3> &C,
                          const ResponseOrder          wanted,
                          ConstitutiveResponse        &state)
    {
      const SymmetricTensor<2, 3> A = invert(C);
      const double                J = std::sqrt(determinant(C));
      state.energy += m * std::log(J);
      state.stress += m * A;
      if (wanted == ResponseOrder::stress)
        return;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int l = k; l < 3; ++l)
              state.tangent[i][j][k][l] -= m * (A[i][k] * A[j][l] + A[i][l] * A[j][k]);
    }



    /// The response with S_zz = 0, by Newton's method for ln C_zz with steps of at most 1/2
    /// (doc/theory, (6.10)). Ends when S_zz is rounding beside its slope; throws std::domain_error
    /// after 100 steps, or where the slope is not positive.
    /// @param C in: in-plane components, C_zz as start; out: with C_zz
    ConstitutiveResponse
    without_thickness_stress(const MaterialPoint &point, SymmetricTensor<2, 3> &C)
    {
      constexpr unsigned int most   = 100;
      constexpr double       enough = 1e-14, longest = 0.5;
      for (unsigned int i = 0; i < most; ++i)
        {
          const ConstitutiveResponse state = point.at(C, ResponseOrder::tangent);
          // The tangent is 2 dS/dC; the derivative with respect to ln C_zz is dS_zz/dC_zz times
          // C_zz. The logarithm keeps the thickness positive, and the limit of the step prevents
          // that a flat start leads to extreme thicknesses.
          const double slope = state.tangent[2][2][2][2] / 2 * C[2][2];
          if (std::abs(state.stress[2][2]) <= enough * std::abs(slope))
            return state;
          if (!(slope > 0))
            break;
          C[2][2] *= std::exp(std::min(longest, std::max(-longest, -state.stress[2][2] / slope)));
        }
      throw std::domain_error("plane stress: there is no thickness stretch with zero transverse "
                              "stress; use smaller load steps");
    }
  } // namespace



  MaterialPoint::MaterialPoint(const Material     &material,
                               const double        volumetric_stress,
                               const double *const internal,
                               const double        duration,
                               const double        temperature_rise)
    : strain_measure(material.constitutive_law ? material.strain_measure : StrainMeasure::small)
    , volumetric_stress(volumetric_stress)
    , law(material.constitutive_law.get())
    , linear(material.lambda(), material.mu())
    , internal(internal)
    , duration(duration)
    , temperature_rise(temperature_rise)
  {}



  // For a law that is compared with another one at the same displacement: without duration.
  MaterialPoint::MaterialPoint(const ConstitutiveLaw &law,
                               const double           volumetric_stress,
                               const double *const    internal,
                               const double           temperature_rise)
    : strain_measure(StrainMeasure::finite)
    , volumetric_stress(volumetric_stress)
    , law(&law)
    , linear(0, 0)
    , internal(internal)
    , duration(0)
    , temperature_rise(temperature_rise)
  {}



  // Materials without a constitutive law are linear elastic.
  ConstitutiveResponse
  MaterialPoint::at(const SymmetricTensor<2, 3> &C, const ResponseOrder wanted) const
  {
    return law ? law->response({C, internal, duration, temperature_rise}, wanted) :
                 linear.at(C, wanted);
  }



  ConstitutiveResponse
  response_at(const Model          model,
              const MaterialPoint &point,
              Tensor<2, 3>        &F,
              const ResponseOrder  wanted)
  {
    // The argument of the law is C = F^T F, at small strain 1 + 2 eps.
    const bool            is_finite_strain = point.strain_measure == StrainMeasure::finite;
    SymmetricTensor<2, 3> C                = is_finite_strain ? symmetrize(transpose(F) * F) :
                                                                2. * symmetrize(F) - unit_symmetric_tensor<3>();
    if (model != Model::plane_stress)
      {
        ConstitutiveResponse state = point.at(C, wanted);
        if (point.volumetric_stress != 0 && is_finite_strain)
          add_volumetric_stress(point.volumetric_stress, C, wanted, state);
        else if (point.volumetric_stress != 0)
          state.stress += point.volumetric_stress * unit_symmetric_tensor<3>();
        return state;
      }
    // Plane stress: solve for the thickness, then condense it out of the tangent (doc/theory,
    // (6.11)).
    ConstitutiveResponse        state  = without_thickness_stress(point, C);
    const SymmetricTensor<4, 3> T      = state.tangent;
    const double                across = T[2][2][2][2];
    // The caller gets F with the thickness stretch that was found; at small strain C stands for 1 +
    // 2 eps.
    F[2][2]            = is_finite_strain ? std::sqrt(C[2][2]) : 1 + (C[2][2] - 1) / 2;
    state.stress[2][2] = 0;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            state.tangent[i][j][k][l] = T[i][j][k][l] - T[i][j][2][2] * T[2][2][k][l] / across;
    return state;
  }



  // Inverted points (J <= 0) and failures of the plane-stress iteration give no response, instead
  // of an exception.
  std::optional<ConstitutiveResponse>
  response_if_any(const Model          model,
                  const MaterialPoint &point,
                  Tensor<2, 3>        &F,
                  const ResponseOrder  wanted)
  {
    if (point.strain_measure == StrainMeasure::finite && !(determinant(F) > 0))
      return {};
    try
      {
        // Only std::domain_error is caught, which the iteration for the thickness throws; other
        // exceptions are passed on.
        return response_at(model, point, F, wanted);
      }
    catch (const std::domain_error &)
      {
        return {};
      }
  }



  // sigma = F S F^T/J at finite strain; at small strain the stress of the law.
  SymmetricTensor<2, 3>
  cauchy_stress(const Model model, const MaterialPoint &point, Tensor<2, 3> F)
  {
    const ConstitutiveResponse state = response_at(model, point, F, ResponseOrder::stress);
    if (point.strain_measure == StrainMeasure::small)
      return state.stress;
    return symmetrize(F * Tensor<2, 3>(state.stress) * transpose(F)) / determinant(F);
  }



  template Tensor<2, 3>
  deformation_gradient(Model, const Tensor<2, 2> &, const Tensor<1, 2> &, const Point<2> &);
  template Tensor<2, 3>
  deformation_gradient(Model, const Tensor<2, 3> &, const Tensor<1, 3> &, const Point<3> &);
} // namespace Signorini
