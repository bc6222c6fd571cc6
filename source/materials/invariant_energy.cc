#include <signorini/materials/invariant_energy.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n = 3;

    /// The derivative of the inverse of a symmetric tensor by it, with the other sign:
    /// (A_ik A_jl + A_il A_jk)/2 with the inverse A.
    SymmetricTensor<4, n>
    symmetric_product(const SymmetricTensor<2, n> &A)
    {
      SymmetricTensor<4, n> result;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = i; j < n; ++j)
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int l = k; l < n; ++l)
              result[i][j][k][l] = 0.5 * (A[i][k] * A[j][l] + A[i][l] * A[j][k]);
      return result;
    }
  } // namespace



  // With dI1/dC = I, dI2/dC = I1 I - C, dJ/dC = J/2 C^-1, and of these
  // d2I2/dC2 = I x I - 1, d2J/dC2 = J/4 C^-1 x C^-1 - J/2 symmetric_product(C^-1).
  HyperelasticState
  InvariantEnergy::at(const SymmetricTensor<2, 3> &C) const
  {
    const double      I1 = trace(C), I2 = 0.5 * (I1 * I1 - C * C), J = std::sqrt(determinant(C));
    const Derivatives w             = derivatives(I1, I2, J);
    const SymmetricTensor<2, 3> one = unit_symmetric_tensor<3>(), inverse = invert(C);
    const std::array<SymmetricTensor<2, 3>, 3> of_C = {{one, I1 * one - C, J / 2 * inverse}};

    HyperelasticState state;
    state.energy = w.value;
    for (unsigned int a = 0; a < 3; ++a)
      {
        state.stress += 2 * w.first[a] * of_C[a];
        for (unsigned int b = 0; b < 3; ++b)
          state.tangent += 4 * w.second[a][b] * outer_product(of_C[a], of_C[b]);
      }
    state.tangent += 4 * w.first[1] * (outer_product(one, one) - identity_tensor<3>());
    state.tangent +=
      w.first[2] * J * (outer_product(inverse, inverse) - 2 * symmetric_product(inverse));
    return state;
  }
} // namespace Signorini
