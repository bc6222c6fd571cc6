#pragma once

#include <array>

namespace Signorini
{
  /// Highest degree of a face.
  constexpr unsigned int max_degree = 4;

  /// Value, first and second derivative of every basis function at one place, without the heap.
  using LagrangeBasis = std::array<std::array<double, 3>, max_degree + 1>;

  /// The polynomials of degree k on k+1 equidistant nodes of [0,1], at x.
  inline LagrangeBasis
  lagrange(const unsigned int k, const double x)
  {
    if (k == 1)
      return {{{{1 - x, -1., 0.}}, {{x, 1., 0.}}}};
    if (k == 2)
      return {{{{(2 * x - 1) * (x - 1), 4 * x - 3, 4.}},
               {{4 * x * (1 - x), 4 - 8 * x, -8.}},
               {{x * (2 * x - 1), 4 * x - 1, 4.}}}};
    // L_i(x) is the product of (kx-j)/(i-j) over j != i; each factor is linear, so the product rule
    // carries the derivatives along.
    LagrangeBasis basis;
    for (unsigned int i = 0; i <= k; ++i)
      {
        double value = 1, first = 0, second = 0, divisor = 1;
        for (unsigned int j = 0; j <= k; ++j)
          if (j != i)
            {
              const double factor = k * x - j;
              second              = second * factor + 2. * k * first;
              first               = first * factor + k * value;
              value *= factor;
              divisor *= double(i) - double(j);
            }
        basis[i] = {{value / divisor, first / divisor, second / divisor}};
      }
    return basis;
  }
} // namespace Signorini
