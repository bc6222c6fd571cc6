#pragma once

#include <signorini/elasticity/model.h>
#include <signorini/materials/hyperelastic.h>

#include <optional>

namespace Signorini
{
  /// F = I + Grad u in space, thesis after (5). Axisymmetric: F_zz = 1 + u_r/R; plane stress: 1,
  /// see fill_thickness().
  /// @param gradient of the displacement: [component][derivative]
  /// @param u the displacement at X, at rest
  template <int dim>
  dealii::Tensor<2, 3>
  deformation_gradient(Model                         model,
                       const dealii::Tensor<2, dim> &gradient,
                       const dealii::Tensor<1, dim> &u,
                       const dealii::Point<dim>     &X);

  /// State of a material where a body is deformed by F, whose bulk stress m, if it has one of its
  /// own, adds m ln J to W (see BulkStress). In plane stress F_zz becomes that which
  /// makes S_zz zero, and the tangent that of the stresses in the plane. Throws std::domain_error
  /// if there is none. J = det F is positive.
  HyperelasticState
  hyperelastic_state(Model                 model,
                     const Hyperelastic   &law,
                     dealii::Tensor<2, 3> &F,
                     double                bulk_stress = 0,
                     UpTo                  wanted      = UpTo::tangent);

  /// The same, or nothing where there is none: where J <= 0, or a sheet has no thickness.
  std::optional<HyperelasticState>
  state_if_any(Model                 model,
               const Hyperelastic   &law,
               dealii::Tensor<2, 3> &F,
               double                bulk_stress = 0,
               UpTo                  wanted      = UpTo::tangent);

  /// sigma = F S F^T/J, the stress on areas as they are now, tension positive.
  dealii::SymmetricTensor<2, 3>
  cauchy_stress(Model                model,
                const Hyperelastic  &law,
                dealii::Tensor<2, 3> F,
                double               bulk_stress = 0);
} // namespace Signorini
