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
} // namespace Signorini
