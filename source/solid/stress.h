// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/material.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
  /// sigma = lambda tr(eps) I + 2 mu eps in space, tension positive, whatever the model: see
  /// strain().
  dealii::SymmetricTensor<2, 3>
  stress(const Material &material, const dealii::SymmetricTensor<2, 3> &strain);

  /// The strain that belongs to a stress, by linear elasticity.
  dealii::SymmetricTensor<2, 3>
  compliance(const Material &material, const dealii::SymmetricTensor<2, 3> &stress);

  double
  von_mises(const dealii::SymmetricTensor<2, 3> &stress);
} // namespace Signorini
