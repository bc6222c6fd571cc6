// SPDX-License-Identifier: Apache-2.0
#include "materials/invariant_energy.h"

#include "materials/symmetric_pairs.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // Equation (6.6) of doc/theory, with dI1/dC = I, dI2/dC = I1 I - C, dJ/dC = J/2 C^-1, and of
  // these d2I2/dC2 = I x I - 1, d2J/dC2 = J/4 C^-1 x C^-1 - J/2 P, where -P is the derivative of
  // C^-1, P_ijkl = (A_ik A_jl + A_il A_jk)/2 with A = C^-1. Tensors are written as arrays of six
  // components, see SymmetricPairs.
  ConstitutiveResponse
  InvariantEnergy::at(const SymmetricTensor<2, 3> &C, const ResponseOrder wanted) const
  {
    using Pairs          = SymmetricPairs;
    const double      I1 = trace(C), I2 = 0.5 * (I1 * I1 - C * C), J = std::sqrt(determinant(C));
    const Derivatives w                            = derivatives(I1, I2, J);
    const SymmetricTensor<2, 3>                one = unit_symmetric_tensor<3>(), A = invert(C);
    const std::array<SymmetricTensor<2, 3>, 3> of_C = {{one, I1 * one - C, J / 2 * A}};

    ConstitutiveResponse state;
    state.energy = w.value;
    for (unsigned int a = 0; a < 3; ++a)
      state.stress += 2 * w.first[a] * of_C[a];

    if (wanted == ResponseOrder::stress)
      return state;

    // First the outer products of the derivatives of the invariants, weighted with the second
    // derivatives of W; then the second derivatives of I2 and J.
    const std::array<Pairs::Values, 3> by = {
      {Pairs::of(of_C[0]), Pairs::of(of_C[1]), Pairs::of(of_C[2])}};
    std::array<Pairs::Values, 3> weighted{};
    std::array<bool, 3>          counts{};
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        if (w.second[a][b] != 0)
          {
            counts[a] = true;
            for (unsigned int p = 0; p < Pairs::size; ++p)
              weighted[a][p] += 4 * w.second[a][b] * by[b][p];
          }
    const double        of_I2 = 4 * w.first[1], of_J = w.first[2] * J;
    const Pairs::Values inverse = Pairs::of(A);
    double              full[3][3]; // A
    for (unsigned int p = 0; p < Pairs::size; ++p)
      full[Pairs::row[p]][Pairs::column[p]] = full[Pairs::column[p]][Pairs::row[p]] = inverse[p];
    for (unsigned int p = 0; p < Pairs::size; ++p)
      {
        const unsigned int i = Pairs::row[p], j = Pairs::column[p];
        double *const      to = Pairs::row_of(state.tangent, p);
        for (unsigned int q = 0; q < Pairs::size; ++q)
          {
            const unsigned int k = Pairs::row[q], l = Pairs::column[q];
            to[q] =
              of_J * (inverse[p] * inverse[q] - full[i][k] * full[j][l] - full[i][l] * full[j][k]);
          }
        for (unsigned int a = 0; a < 3; ++a)
          if (counts[a])
            for (unsigned int q = 0; q < Pairs::size; ++q)
              to[q] += weighted[a][p] * by[a][q];
        to[p] -= of_I2 * (i == j ? 1 : 0.5);
        for (unsigned int q = 0; q < 3 && i == j; ++q)
          to[q] += of_I2;
      }
    return state;
  }
} // namespace Signorini
