// SPDX-License-Identifier: Apache-2.0
#include "materials/stretch_energy.h"

#include "materials/symmetric_pairs.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // Equation (6.7) of doc/theory. With c = l^2 and s = W'/c, the principal values of S: along two
  // axes 2 ds_a/dc_b = W''_ab/(c_a c_b) - 2 delta_ab W'_a/c_a^2, and between them 2 (s_b -
  // s_a)/(c_b - c_a), whose limit for equal stretches is half the difference of the former (Simo
  // and Taylor 1991, see doc/theory).
  ConstitutiveResponse
  StretchEnergy::at(const SymmetricTensor<2, 3> &C, const ResponseOrder wanted) const
  {
    using Pairs = SymmetricPairs;
    // The relative difference of squared stretches below which the limit is used. There the
    // quotient has lost as many digits by cancellation as the limit, which is of second order, is
    // wrong.
    constexpr double nearly_equal = 1e-5;
    const auto       axes = eigenvectors(C, SymmetricTensorEigenvectorMethod::ql_implicit_shifts);
    std::array<double, 3>       c{}, logs{}, s{};
    std::array<Tensor<1, 3>, 3> axis;
    for (unsigned int a = 0; a < 3; ++a)
      {
        c[a]    = axes[a].first;
        axis[a] = axes[a].second;
        logs[a] = std::log(c[a]) / 2;
      }
    const Derivatives w = derivatives(logs);
    for (unsigned int a = 0; a < 3; ++a)
      s[a] = w.first[a] / c[a];
    const auto along = [&](const unsigned int a, const unsigned int b) {
      return w.second[a][b] / (c[a] * c[b]) - (a == b ? 2 * s[a] / c[a] : 0.);
    };

    ConstitutiveResponse state;
    state.energy = w.value;
    std::array<Pairs::Values, 3> product;
    for (unsigned int a = 0; a < 3; ++a)
      {
        const SymmetricTensor<2, 3> of_axis = symmetrize(outer_product(axis[a], axis[a]));
        product[a]                          = Pairs::of(of_axis);
        state.stress += s[a] * of_axis;
      }
    if (wanted == ResponseOrder::stress)
      return state;
    std::array<Pairs::Values, Pairs::size> tangent{};
    const auto                             add =
      [&](const double factor, const Pairs::Values &left, const Pairs::Values &right) {
        for (unsigned int p = 0; p < Pairs::size; ++p)
          for (unsigned int q = 0; q < Pairs::size; ++q)
            tangent[p][q] += factor * left[p] * right[q];
      };
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        {
          add(along(a, b), product[a], product[b]);
          if (b <= a)
            continue;
          const double difference = c[b] - c[a];
          const double shear      = std::abs(difference) > nearly_equal * c[a] ?
                                      (s[b] - s[a]) / difference :
                                      (along(a, a) + along(b, b) - 2 * along(a, b)) / 4;
          const auto   mixed      = Pairs::of(2 * symmetrize(outer_product(axis[a], axis[b])));
          add(shear, mixed, mixed);
        }
    for (unsigned int p = 0; p < Pairs::size; ++p)
      std::copy(tangent[p].begin(), tangent[p].end(), Pairs::row_of(state.tangent, p));
    return state;
  }
} // namespace Signorini
