// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/face_parameter.h"
#include "geometry/lagrange.h"

#include <array>
#include <utility>
#include <variant>
#include <vector>

namespace Signorini
{
  /// The Lagrange polynomials of degree 1 or 2 on the equidistant nodes of the reference simplex of
  /// m dimensions, at one point, in the order of face_lattice(). Functions of degree 2 are products
  /// of two linear ones.
  template <int m>
  class SimplexPolynomials
  {
  public:
    /// The order of a derivative in each coordinate.
    using Index = std::array<unsigned int, m>;

    /// @param k degree, 1 or 2
    /// @param x the point at which all functions are evaluated
    SimplexPolynomials(const unsigned int k, const dealii::Point<m> &x)
    {
      // The barycentric coordinates and their derivatives.
      std::array<Linear, m + 1> lambda;
      lambda[0].value = 1;
      for (unsigned int d = 0; d < m; ++d)
        {
          lambda[0].value -= x[d];
          lambda[0].slope[d]     = -1;
          lambda[d + 1].value    = x[d];
          lambda[d + 1].slope[d] = 1;
        }
      const auto add = [&](const Linear &a, const Linear &b, const double factor) {
        Function &f = functions[n++];
        f.value     = factor * a.value * b.value;
        for (unsigned int d = 0; d < m; ++d)
          {
            f.slope[d] = factor * (a.slope[d] * b.value + a.value * b.slope[d]);
            for (unsigned int e = 0; e < m; ++e)
              f.second[d][e] = factor * (a.slope[d] * b.slope[e] + a.slope[e] * b.slope[d]);
          }
      };
      const auto at_corner = [&](const unsigned int c) {
        // 2 lambda - 1 of degree 2, one of degree 1
        Linear other;
        other.value = k == 2 ? 2 * lambda[c].value - 1 : 1;
        other.slope = k == 2 ? 2 * lambda[c].slope : dealii::Tensor<1, m>();
        add(lambda[c], other, 1);
      };
      const auto between = [&](const unsigned int c, const unsigned int d) {
        if (k == 2)
          add(lambda[c], lambda[d], 4);
      };
      at_corner(0);
      between(0, 1);
      at_corner(1);
      if constexpr (m == 2)
        {
          between(0, 2);
          between(1, 2);
          at_corner(2);
        }
    }

    unsigned int
    size() const
    {
      return n;
    }

    double
    value(const unsigned int node) const
    {
      return functions[node].value;
    }

    dealii::Tensor<1, m>
    gradient(const unsigned int node) const
    {
      return functions[node].slope;
    }

    /// @return the derivative of the polynomial with given nodal values.
    /// @param nodal_values in the order of face_lattice()
    /// @param orders of the derivative in each coordinate, up to 2 in all
    template <typename Sum, typename Value>
    Sum
    derivative_of(const std::vector<Value> &nodal_values, const Index &orders) const
    {
      // The coordinates by which is derived.
      std::array<unsigned int, 2> by{};
      unsigned int                order = 0;
      for (unsigned int d = 0; d < m; ++d)
        for (unsigned int i = 0; i < orders[d]; ++i)
          by[order++] = d;
      Sum sum{};
      for (unsigned int i = 0; i < n; ++i)
        {
          const Function &f = functions[i];
          sum += (order == 0 ? f.value :
                  order == 1 ? f.slope[by[0]] :
                               f.second[by[0]][by[1]]) *
                 nodal_values[i];
        }
      return sum;
    }

  private:
    struct Linear
    {
      double               value = 0;
      dealii::Tensor<1, m> slope;
    };

    struct Function : public Linear
    {
      dealii::Tensor<2, m> second;
    };

    unsigned int                                n = 0;
    std::array<Function, (m + 1) * (m + 2) / 2> functions;
  };



  /// The Lagrange polynomials of a face at one point, (3.1) of doc/theory, in the order of
  /// face_lattice(): those of a line, of a triangle, or products of those of two lines.
  template <int dim>
  class FaceFunctions
  {
  public:
    static constexpr int m = dim - 1;
    using Index            = std::array<unsigned int, m>;

    /// @param shape the reference cell of the face
    /// @param k degree, 1 to max_degree; on triangles 1 or 2
    /// @param xi the point at which all functions are evaluated
    FaceFunctions(const dealii::ReferenceCell &shape,
                  const unsigned int           k,
                  const dealii::Point<m>      &xi)
      : functions(is_triangle(shape) ? Any(std::in_place_index<1>, k, xi) :
                                       Any(std::in_place_index<0>, k, xi))
    {}

    unsigned int
    size() const
    {
      return std::visit([](const auto &f) { return f.size(); }, functions);
    }

    double
    value(const unsigned int node) const
    {
      return std::visit([&](const auto &f) { return f.value(node); }, functions);
    }

    dealii::Tensor<1, m>
    gradient(const unsigned int node) const
    {
      return std::visit([&](const auto &f) { return f.gradient(node); }, functions);
    }

    /// @return the derivative of the polynomial with given nodal values.
    /// @param nodal_values in the order of face_lattice()
    /// @param orders of the derivative in each coordinate
    template <typename Sum, typename Value>
    Sum
    derivative_of(const std::vector<Value> &nodal_values, const Index &orders) const
    {
      return std::visit(
        [&](const auto &f) { return f.template derivative_of<Sum>(nodal_values, orders); },
        functions);
    }

  private:
    using Any = std::variant<LagrangePolynomials<m>, SimplexPolynomials<m>>;

    const Any functions;
  };
} // namespace Signorini
