#pragma once

#include <signorini/elasticity/material.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
  /// All components in space, tension positive. In 2D the strain is plane, so that
  /// sigma_zz = nu (sigma_xx + sigma_yy).
  /// @param gradient of the displacement: [component][derivative]
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  stress(const Material &material, const dealii::Tensor<2, dim> &gradient);

  double
  von_mises(const dealii::SymmetricTensor<2, 3> &stress);
} // namespace Signorini
