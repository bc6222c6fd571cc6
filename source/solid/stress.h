// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/material.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
  /// The stress sigma = lambda tr(eps) I + 2 mu eps in three dimensions, tension positive; the
  /// model is in the strain, see strain().
  dealii::SymmetricTensor<2, 3>
  stress(const Material &material, const dealii::SymmetricTensor<2, 3> &strain);

  /// The strain of a stress by linear elasticity, the inverse of stress().
  dealii::SymmetricTensor<2, 3>
  compliance(const Material &material, const dealii::SymmetricTensor<2, 3> &stress);

  /// The von Mises stress sqrt(3/2) |dev sigma| [force/area].
  double
  von_mises(const dealii::SymmetricTensor<2, 3> &stress);
} // namespace Signorini
