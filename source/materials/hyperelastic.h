// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/constitutive_law.h>

namespace Signorini
{
  /// A stored energy W(C) of the right Cauchy-Green tensor C = F^T F, isotropic and free of stress
  /// in the reference configuration, with its derivatives: S = 2 dW/dC, (6.1) of doc/theory. It has
  /// no internal variables.
  class Hyperelastic : public ConstitutiveLaw
  {
  public:
    /// @return energy, stress S, and if `wanted` the tangent 2 dS/dC.
    /// @param C positive definite
    /// @param wanted the highest derivative
    virtual ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const = 0;

    /// The response depends on C alone.
    ConstitutiveResponse
    response(const ConstitutiveInput &in, const ResponseOrder wanted) const override
    {
      return at(in.C, wanted);
    }
  };
} // namespace Signorini
