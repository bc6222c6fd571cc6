#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// The functions psi_A, one a slave node, in which methods that sample at nodes expand the
  /// pressure, and with which they weight the gap.
  enum class Basis
  {
    standard, ///< the trace of the displacement's shape functions phi_A
    dual      ///< int psi_A phi_B dA = delta_AB int phi_B dA (Wohlmuth, SIAM J. Numer. Anal. 38
              ///< (2000) 989-1012)
  };

  /// Where contact integrals are evaluated on a slave face.
  struct Integration
  {
    std::string  rule     = "segments";      ///< one of names()
    unsigned int n_points = 3;               ///< quadrature points a direction; nodes: degree + 1
    Basis        basis    = Basis::standard; ///< of the weights, for methods that sample at nodes
    unsigned int n_points_of_distorted = 0;  ///< on segments of faces that are no parallelograms by
                                             ///< far; 0: n_points

    static const std::vector<std::string> &
    names();
  };
} // namespace Signorini
