// SPDX-License-Identifier: Apache-2.0
#include "solid/stress.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // Hooke's law with Lame's constants (doc/theory, (1.1)). In mixed bodies lambda is zero, and the
  // volumetric stress is added by the caller.
  SymmetricTensor<2, 3>
  stress(const Material &material, const SymmetricTensor<2, 3> &strain)
  {
    return material.lambda() * trace(strain) * unit_symmetric_tensor<3>() +
           2 * material.mu() * strain;
  }



  // The inverse of Hooke's law in terms of E and nu.
  SymmetricTensor<2, 3>
  compliance(const Material &material, const SymmetricTensor<2, 3> &stress)
  {
    return ((1 + material.poissons_ratio) * stress -
            material.poissons_ratio * trace(stress) * unit_symmetric_tensor<3>()) /
           material.youngs_modulus;
  }



  // sqrt(3/2 s:s) of the deviator s, which is the absolute stress in uniaxial tension.
  double
  von_mises(const SymmetricTensor<2, 3> &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }
} // namespace Signorini
