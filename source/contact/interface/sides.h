// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// Comparison of slave and master where they face each other: geometric means over the contact
  /// area, the same on all ranks. It decides which surface should be slave.
  struct Sides
  {
    /// Ratio of Young's moduli, slave over master.
    double modulus = 1;
    /// Ratio of face sizes, slave over master.
    double size = 1;

    /// The criterion R for oscillations of the pressure (doc/theory, (3.12)).
    ///
    /// An alternating pressure p on the slave moves its nodes by h_S/E_S p. The master mesh cannot
    /// represent the curved part of its displacement p h_M/E_M, and the slave compensates the rest
    /// by a pressure of E_S/h_S times that: relative to p it is E_S/E_M (h_M/h_S), and two more
    /// factors h_M/h_S come from the smooth part. Measured (doc/benchmarks/measurements.md): the
    /// pressure oscillates by some percent from R = 4 on, and by its own size from some hundreds
    /// on.
    /// @return R, at least the ratio of the moduli
    double
    pressure_error() const;

    /// The comparison with the roles of slave and master exchanged.
    Sides
    exchanged() const
    {
      return {1 / modulus, 1 / size};
    }

    /// True if the exchange of slave and master is a clear improvement (doc/theory, 3.6); the
    /// program then makes it where the settings allow it.
    bool
    should_be_exchanged() const;
  };
} // namespace Signorini
