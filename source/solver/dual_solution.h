// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"

namespace Signorini
{
  /// The dual (adjoint) solution of a quantity J(u, p): its sensitivity to perturbations of the
  /// equations that u and p solve. With the linearisation M of solids and contact at the solution,
  /// and M (du, dp) = (r, W d) for residual forces r and gap residuals d,
  ///
  ///   J(u + du, p + dp) - J(u, p) = z.r + zeta.(W d),   M^T (z, zeta) = (dJ/du, dJ/dp).
  ///
  /// Bodies in displacement-pressure form have residuals of their volume in addition.
  struct DualSolution
  {
    LA::Vector   z;                 ///< [J per force], a displacement with homogeneous supports
    PointVectors zeta;              ///< [J per force], of each component; zero at open points
    LA::Vector   volumetric_stress; ///< coefficients of the dual one; empty: no body has one
    double remainder = 0; ///< z.r + zeta.(W d) for the residuals that Newton's method has left
    unsigned int iterations = 0; ///< of the linear solver
  };
} // namespace Signorini
