// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/stored_energies.h"
#include <signorini/materials/material.h>
#include <signorini/solid/model.h>

#include <optional>

namespace Signorini
{
  /// The deformation gradient F = I + Grad u in three dimensions (doc/theory, 6.1). Axisymmetric:
  /// F_zz = 1 + u_r/R; plane strain: 1; plane stress: 1, which response_at() replaces.
  /// @param gradient gradient of the displacement: [component][derivative]
  /// @param u displacement at X
  /// @param X point in the reference configuration
  template <int dim>
  dealii::Tensor<2, 3>
  deformation_gradient(Model                         model,
                       const dealii::Tensor<2, dim> &gradient,
                       const dealii::Tensor<1, dim> &u,
                       const dealii::Point<dim>     &X);

  /// A material at a point of a body, with the data beside the strain that its law needs.
  struct MaterialPoint
  {
    /// Refers to the material. Without a constitutive law the material is linear elastic, lambda
    /// tr(eps) I + 2 mu eps.
    /// @param volumetric_stress m of a body in displacement-pressure form [force/area]
    /// @param internal internal variables at the start of the load step; null: none
    /// @param duration of the load step [time]
    /// @param temperature_rise T - T_0
    explicit MaterialPoint(const Material &material,
                           double          volumetric_stress = 0,
                           const double   *internal          = nullptr,
                           double          duration          = 0,
                           double          temperature_rise  = 0);

    /// A point of a material with that law of finite strain.
    /// @param internal internal variables, law.n_internal() of them; null: none
    /// @param temperature_rise T - T_0
    MaterialPoint(const ConstitutiveLaw &law,
                  double                 volumetric_stress = 0,
                  const double          *internal          = nullptr,
                  double                 temperature_rise  = 0);

    /// The response of the law: stress S, and tangent 2 dS/dC and energy as far as wanted. @param C
    /// C = F^T F at finite strain, 1 + 2 eps at small strain
    ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const;

    StrainMeasure strain_measure;
    /// The volumetric stress m of a body in displacement-pressure form [force/area]; otherwise 0.
    double volumetric_stress;

  private:
    const ConstitutiveLaw     *law; ///< null: linear elasticity
    const SaintVenantKirchhoff linear;
    const double              *internal;
    double                     duration, temperature_rise;
  };

  /// The response of a material to the deformation gradient F; the volumetric stress m of a body in
  /// displacement-pressure form adds m ln J to the energy (doc/theory, (6.16)). In plane stress
  /// F_zz is set to the value for which S_zz = 0, and the tangent is condensed to the in-plane
  /// components (6.11). Throws std::domain_error if there is none.
  /// @param F with det F > 0; in plane stress F_zz is set
  ConstitutiveResponse
  response_at(Model                 model,
              const MaterialPoint  &point,
              dealii::Tensor<2, 3> &F,
              ResponseOrder         wanted = ResponseOrder::tangent);

  /// response_at(), or nothing where there is none: where J <= 0, or where plane stress has no
  /// solution.
  std::optional<ConstitutiveResponse>
  response_if_any(Model                 model,
                  const MaterialPoint  &point,
                  dealii::Tensor<2, 3> &F,
                  ResponseOrder         wanted = ResponseOrder::tangent);

  /// The Cauchy stress sigma = F S F^T/J on current areas [force/area], tension positive; at small
  /// strain S.
  dealii::SymmetricTensor<2, 3>
  cauchy_stress(Model model, const MaterialPoint &point, dealii::Tensor<2, 3> F);
} // namespace Signorini
