// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

namespace Signorini
{
  /// The stress at a point of a body, and its linearisation there by the gradient G of a change of
  /// displacement and, in displacement-pressure form, by a change q of the volumetric stress. At
  /// small strain all stresses are sigma. Gradients have three dimensions in all models, with
  /// derivatives in the reference configuration: [component][derivative].
  struct StressState
  {
    /// First Piola-Kirchhoff stress P [force/reference area], with volumetric and thermal parts;
    /// not symmetric.
    dealii::Tensor<2, 3> stress;
    /// Stored energy per reference volume, in displacement-pressure form with m theta - m^2/(2
    /// lambda), which is stationary.
    double energy = 0;
    /// theta - m/lambda, which is zero on average in displacement-pressure form, see
    /// VolumetricStress; otherwise 0.
    double volume_residual = 0;

    /// @return the derivative of P.
    dealii::Tensor<2, 3>
    change_of_stress(const dealii::Tensor<2, 3> &G, double q) const;

    /// @return the derivative of the residual of the volume; 0 in displacement form.
    double
    change_of_volume_residual(const dealii::Tensor<2, 3> &G, double q) const;

    /// @return the derivative of the Cauchy stress.
    dealii::SymmetricTensor<2, 3>
    change_of_cauchy_stress(const dealii::Tensor<2, 3> &G, double q) const;

    /// Deformation gradient, with the stretch of the thickness in plane stress; 1 at small strain.
    dealii::Tensor<2, 3> F = dealii::unit_symmetric_tensor<3>();
    /// Its inverse.
    dealii::Tensor<2, 3> inverse = dealii::unit_symmetric_tensor<3>();
    /// S and 2 dS/dC of the law.
    ConstitutiveResponse response;
    bool                 is_small = true, is_mixed = false;
    /// 1/lambda of the volumetric stress.
    double compliance = 0;
    /// In plane stress at finite strain, the change of C_zz with the other components of C, for
    /// which S_zz remains zero; otherwise zero.
    dealii::SymmetricTensor<2, 3> thickness;
  };

  /// @return the gradient of a change of displacement in three dimensions, with the hoop strain of
  /// axisymmetric models.
  template <int dim>
  dealii::Tensor<2, 3>
  gradient_of_change(const Model                   model,
                     const dealii::Tensor<2, dim> &gradient,
                     const dealii::Tensor<1, dim> &change,
                     const dealii::Point<dim>     &X)
  {
    return deformation_gradient(model, gradient, change, X) -
           dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  }

  /// @return the state at a point X of a locally owned or ghost cell. Throws std::domain_error
  /// where plane stress has no solution.
  /// @param gradient of the displacement
  /// @param u displacement at X
  template <int dim>
  StressState
  stress_state(const Elasticity<dim>           &elasticity,
               const dealii::CellAccessor<dim> &cell,
               const dealii::Tensor<2, dim>    &gradient,
               const dealii::Tensor<1, dim>    &u,
               const dealii::Point<dim>        &X);
} // namespace Signorini
