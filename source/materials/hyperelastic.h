// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/materials/constitutive_law.h>

namespace Signorini
{
  /// A stored energy W(C) of the right Cauchy-Green tensor C = F^T F (doc/theory, 6.1), isotropic
  /// and free of stress at rest, with its derivatives: S = 2 dW/dC. It remembers nothing.
  class Hyperelastic : public ConstitutiveLaw
  {
  public:
    virtual ConstitutiveResponse
    at(const dealii::SymmetricTensor<2, 3> &C, ResponseOrder wanted) const = 0;

    ConstitutiveResponse
    response(const ConstitutiveInput &in, const ResponseOrder wanted) const override
    {
      return at(in.C, wanted);
    }
  };
} // namespace Signorini
