// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/choices.h>

namespace Signorini
{
  /// The functions psi_A of the slave nodes in which methods that sample at nodes expand the
  /// pressure, and with which they weight the gap (doc/theory, 3.4).
  enum class Basis
  {
    standard, ///< the trace of the displacement's shape functions phi_A
    dual      ///< int psi_A phi_B dA = delta_AB int phi_B dA (Wohlmuth, SIAM J. Numer. Anal. 38
              ///< (2000) 989-1012)
  };

  /// The points at which contact integrals are evaluated.
  enum class Rule
  {
    segments,   ///< on the intersections of slave faces with master faces
    quadrature, ///< Gauss points of whole slave faces
    nodes       ///< the slave nodes
  };

  /// Where contact integrals are evaluated on a slave face.
  struct Integration
  {
    Rule rule = Rule::segments;
    /// Quadrature points in each direction; degree + 1 for nodes.
    unsigned int n_points = 3;
    Basis        basis    = Basis::standard; ///< of the weights, for methods that sample at nodes
    unsigned int n_points_of_distorted = 0;  ///< on segments of faces that are no parallelograms by
                                             ///< far; 0: n_points

    /// The rules by the names that the input file uses.
    static const Choices<Rule> &
    rules();
  };
} // namespace Signorini
