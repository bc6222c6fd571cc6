// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// Estimates of the error of a solution in each active cell; entries of cells of other ranks are
  /// zero.
  struct CellErrors
  {
    /// Square of the energy norm of the error, int e:sigma(e) dV.
    std::vector<double> energy;
    /// [quantity][cell]: the energy product of the errors of the solution and of the dual solution,
    /// (8.6).
    std::vector<std::vector<double>> products;
    /// For each quantity the square of the energy norm of the error of the dual solution, summed
    /// over all ranks.
    std::vector<double> energies_of_duals;
    /// int sigma:eps dV of the solution, summed over all ranks.
    double energy_of_solution = 0;
  };

  /// Estimate the errors by recovered stresses: with e the error of the solution and e_z that of a
  /// dual one, J(u) - J(u_h) = a(e, e_z) by Galerkin orthogonality, where the recovered stresses
  /// replace the exact ones, (8.6). Collective.
  /// @param elasticity the model
  /// @param displacement the solution
  /// @param duals dual displacements, one for each quantity
  /// @return the estimates
  template <int dim>
  CellErrors
  cell_errors(const Elasticity<dim>         &elasticity,
              const LA::Vector              &displacement,
              const std::vector<LA::Vector> &duals);
} // namespace Signorini
