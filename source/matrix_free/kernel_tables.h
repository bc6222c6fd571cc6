// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// One-dimensional functions on [0, 1] at the points of Gauss' rule with as many points as there
  /// are functions: those of a degree through equidistant nodes.
  template <typename Number, int degree>
  struct KernelTables
  {
    static constexpr int n = degree + 1;

    KernelTables();

    Number values[n][n];      ///< [point][node]: of the functions
    Number derivatives[n][n]; ///< [point][other]: of the polynomials that are one at one point
    Number weights[n];        ///< of the points
  };

  /// Functions of that degree as combinations of Legendre's polynomials L_i(2 x - 1), with
  /// coefficients kappa_i m_i so that the m_i come from values at the nodes by small integers (see
  /// to_modes()): kappa = 1/2, 1/2; or 1/6, 1/2, 1/3.
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
