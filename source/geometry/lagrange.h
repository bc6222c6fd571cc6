// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// Highest degree of a face.
  constexpr unsigned int max_degree = 4;

  /// Value, first and second derivative of each basis function at one point, in a fixed array
  /// without dynamic memory.
  using LagrangeBasis = std::array<std::array<double, 3>, max_degree + 1>;

  /// @return the basis with the signs of the first derivatives corrected for the functions beyond
  /// the middle, which are computed as functions of -s.
  inline LagrangeBasis
  mirrored(LagrangeBasis basis, const unsigned int k)
  {
    for (unsigned int i = k / 2 + 1; i <= k; ++i)
      basis[i][1] *= -1;
    return basis;
  }

  /// @return the Lagrange polynomials of degree k (1 to 4) on k+1 equidistant nodes of [0,1], at x.
  inline LagrangeBasis
  lagrange(const unsigned int k, const double x)
  {
    if (k == 1)
      return {{{{1 - x, -1., 0.}}, {{x, 1., 0.}}}};
    if (k == 2)
      return {{{{(2 * x - 1) * (x - 1), 4 * x - 3, 4.}},
               {{4 * x * (1 - x), 4 - 8 * x, -8.}},
               {{x * (2 * x - 1), 4 * x - 1, 4.}}}};
    // In the variable s = kx - k/2 functions are mirror images of each other. Values are products
    // of factors, which are exact at the nodes.
    const double s = k * x - 0.5 * k, ss = s * s;
    if (k == 3)
      {
        const auto outer = [ss](const double s) {
          return std::array<double, 3>{{(ss - 0.25) * (1.5 - s) / 6,
                                        (0.25 + (3 - 3 * s) * s) * (3. / 6),
                                        (3 - 6 * s) * (9. / 6)}};
        };
        const auto inner = [ss](const double s) {
          return std::array<double, 3>{{(ss - 2.25) * (s - 0.5) / 2,
                                        ((3 * s - 1) * s - 2.25) * (3. / 2),
                                        (6 * s - 1) * (9. / 2)}};
        };
        return mirrored({{outer(s), inner(s), inner(-s), outer(-s)}}, k);
      }
    const auto outer = [ss](const double s) {
      return std::array<double, 3>{{s * (ss - 1) * (s - 2) / 24,
                                    (((4 * s - 6) * s - 2) * s + 2) * (4. / 24),
                                    ((12 * s - 12) * s - 2) * (16. / 24)}};
    };
    const auto inner = [ss](const double s) {
      return std::array<double, 3>{{s * (ss - 4) * (1 - s) / 6,
                                    (((3 - 4 * s) * s + 8) * s - 4) * (4. / 6),
                                    ((6 - 12 * s) * s + 8) * (16. / 6)}};
    };
    const std::array<double, 3> middle = {
      {(ss - 1) * (ss - 4) / 4, (4 * ss - 10) * s, (12 * ss - 10) * 4}};
    return mirrored({{outer(s), inner(s), middle, inner(-s), outer(-s)}}, k);
  }

  /// The tensor product Lagrange polynomials of degree k on the (k+1)^m equidistant nodes of
  /// [0,1]^m, at one point: the shape functions of a face (m = dim-1, nodes as in face_lattice()),
  /// (3.1) of doc/theory, or of a cell (m = dim). Nodes are in lexicographic order, the first
  /// coordinate running fastest.
  template <int m>
  class LagrangePolynomials
  {
  public:
    /// The number of a node along each coordinate, or the order of a derivative in each.
    using Index = std::array<unsigned int, m>;

    /// @param k degree, 1 to max_degree
    /// @param x the point at which all functions are evaluated
    LagrangePolynomials(const unsigned int k, const dealii::Point<m> &x)
      : k(k)
    {
      for (unsigned int d = 0; d < m; ++d)
        along[d] = lagrange(k, x[d]);
    }

    /// @return the number of functions.
    unsigned int
    size() const
    {
      unsigned int n = 1;
      for (unsigned int d = 0; d < m; ++d)
        n *= k + 1;
      return n;
    }

    /// @return a derivative of a function; the sum of the orders may be up to 2m.
    /// @param node of the function
    /// @param orders of the derivative in each coordinate, 0 to 2
    double
    derivative(const Index &node, const Index &orders) const
    {
      double product = along[0][node[0]][orders[0]];
      for (unsigned int d = 1; d < m; ++d)
        product *= along[d][node[d]][orders[d]];
      return product;
    }

    double
    value(const Index &node) const
    {
      return derivative(node, {});
    }

    dealii::Tensor<1, m>
    gradient(const Index &node) const
    {
      dealii::Tensor<1, m> result;
      for (unsigned int d = 0; d < m; ++d)
        {
          Index orders{};
          orders[d] = 1;
          result[d] = derivative(node, orders);
        }
      return result;
    }

    /// @return the value of a function.
    /// @param node its number in lexicographic order
    double
    value(const unsigned int node) const
    {
      return value(index(node));
    }

    dealii::Tensor<1, m>
    gradient(const unsigned int node) const
    {
      return gradient(index(node));
    }

    /// @return on a face, the derivative of the polynomial with given nodal values.
    /// @param nodal_values in lexicographic order
    /// @param orders of the derivative in each coordinate, 0 to 2
    template <typename Sum, typename Value>
    Sum
    derivative_of(const std::vector<Value> &nodal_values, const Index &orders) const
    {
      static_assert(m <= 2);
      Sum                sum{};
      const unsigned int n_rows = m == 2 ? k + 1 : 1;
      for (unsigned int j = 0; j < n_rows; ++j)
        {
          Sum row{};
          for (unsigned int i = 0; i <= k; ++i)
            row += along[0][i][orders[0]] * nodal_values[j * (k + 1) + i];
          sum += (m == 2 ? along[m - 1][j][orders[m - 1]] : 1.) * row;
        }
      return sum;
    }

  private:
    /// @return the numbers of a node along each coordinate.
    Index
    index(unsigned int node) const
    {
      Index result;
      for (unsigned int d = 0; d < m; ++d, node /= k + 1)
        result[d] = node % (k + 1);
      return result;
    }

    const unsigned int k;
    /// The one-dimensional functions along each coordinate.
    std::array<LagrangeBasis, m> along;
  };
} // namespace Signorini
