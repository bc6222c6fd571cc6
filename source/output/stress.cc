#include <signorini/output/stress.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  SymmetricTensor<2, 3>
  stress(const Material &material, const Tensor<2, dim> &gradient)
  {
    SymmetricTensor<2, 3> strain;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        strain[i][j] = (gradient[i][j] + gradient[j][i]) / 2;
    return material.lambda() * trace(strain) * unit_symmetric_tensor<3>() +
           2 * material.mu() * strain;
  }



  double
  von_mises(const SymmetricTensor<2, 3> &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }



  template SymmetricTensor<2, 3>
  stress(const Material &, const Tensor<2, 2> &);
  template SymmetricTensor<2, 3>
  stress(const Material &, const Tensor<2, 3> &);
} // namespace Signorini
