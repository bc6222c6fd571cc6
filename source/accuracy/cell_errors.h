// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"

#include <vector>

namespace Signorini
{
  /// Estimates of the error of a solution in each active cell, of this rank's own.
  struct CellErrors
  {
    std::vector<double> energy; ///< square of the energy norm, (int e:sigma(e) dV)
    /// By quantity: the product of the errors of the solution and of the dual one in the energy.
    std::vector<std::vector<double>> products;
    std::vector<double> energies_of_duals;      ///< of their errors, likewise squares, on all ranks
    double              energy_of_solution = 0; ///< int sigma:eps dV, on all ranks
  };

  /// By recovered stresses (RecoveredStress): with e the error of the solution and e_z that of a
  /// dual one, J(u) - J(u_h) = a(e, e_z) by Galerkin orthogonality, where both stresses are taken
  /// for what recovery says. Collective.
  /// @param duals displacements, one a quantity
  template <int dim>
  CellErrors
  cell_errors(const Elasticity<dim>         &elasticity,
              const LA::Vector              &displacement,
              const std::vector<LA::Vector> &duals);
} // namespace Signorini
