// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// What happens on boundaries adds to the error of each quantity, cell by cell.
  struct BoundaryErrors
  {
    /// [quantity][cell]: supports prescribe more than the elements can follow. With z the dual
    /// displacement, - int sigma(z) n.(u_D - u_h) dA.
    std::vector<std::vector<double>> of_supports;
    /// Likewise, cells leave out (d > 0) or add a strip of thickness d along a curved boundary
    /// (Hadamard's formula), and what acts or is prescribed on the true boundary acts on theirs:
    /// - int d (sigma(u):eps(z) - sigma(u) n.dz/dn - sigma(z) n.du/dn) dA.
    std::vector<std::vector<double>> of_geometry;
  };

  /// Collective.
  /// @param duals displacements, one a quantity
  template <int dim>
  BoundaryErrors
  boundary_errors(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<LA::Vector> &duals);
} // namespace Signorini
