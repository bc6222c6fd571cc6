// SPDX-License-Identifier: Apache-2.0
#include "solid/stress.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  SymmetricTensor<2, 3>
  stress(const Material &material, const SymmetricTensor<2, 3> &strain)
  {
    return material.lambda() * trace(strain) * unit_symmetric_tensor<3>() +
           2 * material.mu() * strain;
  }



  SymmetricTensor<2, 3>
  compliance(const Material &material, const SymmetricTensor<2, 3> &stress)
  {
    return ((1 + material.poissons_ratio) * stress -
            material.poissons_ratio * trace(stress) * unit_symmetric_tensor<3>()) /
           material.youngs_modulus;
  }



  double
  von_mises(const SymmetricTensor<2, 3> &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }
} // namespace Signorini
