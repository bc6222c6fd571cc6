// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/saint_venant_kirchhoff.h"
#include <signorini/materials/material.h>
#include <signorini/solid/model.h>

#include <optional>

namespace Signorini
{
  /// F = I + Grad u in space (doc/theory, 6.1). Axisymmetric: F_zz = 1 + u_r/R; plane stress: 1,
  /// see fill_thickness().
  /// @param gradient of the displacement: [component][derivative]
  /// @param u the displacement at X, at rest
  template <int dim>
  dealii::Tensor<2, 3>
  deformation_gradient(Model                         model,
                       const dealii::Tensor<2, dim> &gradient,
                       const dealii::Tensor<1, dim> &u,
                       const dealii::Point<dim>     &X);

  /// A material at a point of a body, with the data beside the strain that its law needs.
  struct MaterialPoint
  {
    /// Refers to the material. Without a constitutive law of its own it has that of linear
    /// elasticity, lambda tr(eps) I + 2 mu eps.
    explicit MaterialPoint(const Material &material,
                           double          volumetric_stress = 0,
                           const double   *internal          = nullptr,
                           double          duration          = 0,
                           double          temperature_rise  = 0);

    /// A point of a material whose law has no internal variables.
    MaterialPoint(const ConstitutiveLaw &law, double volumetric_stress = 0);

    ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const;

    StrainMeasure strain_measure;
    double        volumetric_stress; ///< m, of a mixed body

  private:
    const ConstitutiveLaw     *law; ///< null: linear elasticity
    const SaintVenantKirchhoff linear;
    const double              *internal;
    double                     duration, temperature_rise;
  };

  /// The response where a body is deformed by F, whose volumetric stress m, if it has one of its
  /// own, adds m ln J to W (see VolumetricStress). In plane stress F_zz becomes that which makes
  /// S_zz zero, and the tangent that of the stresses in the plane. Throws std::domain_error if
  /// there is none. J = det F is positive.
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

  /// sigma = F S F^T/J, the stress on areas as they are now, tension positive; of small strain S.
  dealii::SymmetricTensor<2, 3>
  cauchy_stress(Model model, const MaterialPoint &point, dealii::Tensor<2, 3> F);
} // namespace Signorini
