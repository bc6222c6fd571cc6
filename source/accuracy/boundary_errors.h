// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// Contributions of boundaries to the error of each quantity, (8.7), cell by cell, exact minus
  /// computed. Only entries of locally owned cells are set.
  struct BoundaryErrors
  {
    /// [quantity][cell]: supports prescribe more than the elements can follow. With z the dual
    /// displacement, - int sigma(z) n.(u_D - u_h) dA.
    std::vector<std::vector<double>> of_supports;
    /// [quantity][cell]: cells omit (d > 0) or add a strip of thickness d along a curved boundary
    /// (Hadamard's formula), and loads and supports act on the boundary of the cells instead of the
    /// true one: - int d (sigma(u):eps(z) - sigma(u) n.dz/dn - sigma(z) n.du/dn) dA.
    std::vector<std::vector<double>> of_geometry;
  };

  /// @return the contributions of boundaries. Collective.
  /// @param elasticity the model
  /// @param displacement the solution
  /// @param duals dual displacements, one for each quantity
  template <int dim>
  BoundaryErrors
  boundary_errors(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<LA::Vector> &duals);
} // namespace Signorini
