// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace Signorini
{
  /// Comparison of slave and master where they face each other: geometric means over the contact
  /// area, the same on all ranks. It decides which surface should be slave.
  struct Sides
  {
    double modulus = 1; ///< E of the slave / E of the master
    double size    = 1; ///< of the slave's faces / of the master's

    /// How much of the pressure the error of the master's mesh can become, up to a factor of some
    /// percent.
    ///
    /// A pressure on the slave that changes from node to node moves the slave by h_S/E_S; the
    /// master follows only what its own faces are fine enough for. What it does not follow, some
    /// h_M^2 of its curved displacement p h_M/E_M over h_M^2, the slave alone makes up for, by a
    /// pressure of E_S/h_S times that: relative to p it is E_S/E_M (h_M/h_S), and what is left of
    /// the smooth part goes with (h_M/h_S)^2 more. Measured (doc/benchmarks/measurements.md): some
    /// percents of waves of the pressure from 4 on, as much as the pressure from some hundreds on.
    double
    pressure_error() const;

    /// The comparison with the roles of slave and master exchanged.
    Sides
    exchanged() const
    {
      return {1 / modulus, 1 / size};
    }

    /// True if exchanging slave and master is so clearly better that the program does it where it
    /// is free to choose.
    bool
    should_be_exchanged() const;
  };
} // namespace Signorini
