// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// One-dimensional shape functions on [0, 1], through equidistant nodes, at the points of the
  /// Gauss rule with as many points as functions.
  template <typename Number, int degree>
  struct KernelTables
  {
    static constexpr int n = degree + 1;

    KernelTables();

    /// [point][node]: values of the shape functions.
    Number values[n][n];
    /// [point][other point]: derivatives of the polynomials through the Gauss points.
    Number derivatives[n][n];
    /// Quadrature weights.
    Number weights[n];
  };

  /// The quadrature rule of the stiffness of tetrahedra, exact for polynomials of degree 5; for
  /// degree 1, whose gradients are constant, one point.
  template <typename Number, int degree>
  struct SimplexTables
  {
    static constexpr int n_points = degree == 1 ? 1 : 14;
    /// Of a function of the points, sum_q l_a l_b f_q for the pairs 00, 01, 11, 02, 12, 22, 03, ...
    /// of vertices: gradients are linear, so that no more of a tangent is needed.
    static constexpr int n_moments = degree == 1 ? 1 : 10;

    SimplexTables();

    /// The factor of a point in a moment. @param a,b vertices
    Number
    moment_factor(const int q, const int a, const int b) const
    {
      return degree == 1 ? 1 : values[q][a] * values[q][b];
    }

    /// The number of a moment. @param a at least b
    static constexpr int
    moment(const int a, const int b)
    {
      return a * (a + 1) / 2 + b;
    }

    /// [point][vertex]: barycentric coordinates; for degree 1 one.
    Number values[n_points][degree == 1 ? 1 : 4];
    /// Quadrature weights; their sum is the volume of the reference cell, 1/6.
    Number weights[n_points];
  };

  /// Scaling of the Legendre polynomials L_i(2 x - 1): functions of the degree have coefficients
  /// kappa_i m_i, where the m_i follow from values at the nodes by small integers (see to_modes());
  /// kappa = 1/2, 1/2 for degree 1, and 1/6, 1/2, 1/3 for degree 2.
  template <typename Number, int degree>
  struct Legendre;

  template <typename Number>
  struct Legendre<Number, 1>
  {
    Number derivatives[1] = {2}; ///< 2 (2 i + 1) kappa_(i+1) / kappa_i, as L_(i+1)' = (2 i + 1) L_i
    Number weights[2]     = {Number(1. / 4), Number(1. / 12)}; ///< kappa_i^2 int L_i^2 dx
  };

  template <typename Number>
  struct Legendre<Number, 2>
  {
    Number derivatives[2] = {6, 4};
    Number weights[3]     = {Number(1. / 36), Number(1. / 12), Number(1. / 45)};
  };
} // namespace Signorini
