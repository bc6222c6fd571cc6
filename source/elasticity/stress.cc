#include <signorini/elasticity/stress.h>

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



  double
  von_mises(const SymmetricTensor<2, 3> &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }
} // namespace Signorini
