// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/elasticity.h"
#include "solver/linear_solver.h"

namespace Signorini
{
  /// The reference cost of a contact solution: the linear elastic solution of the bodies without
  /// contact on the same mesh.
  struct LinearReference
  {
    double seconds_assembly = 0, seconds_preconditioner = 0, seconds_krylov = 0;
    /// Iterations with the near-null space that needs fewer.
    unsigned int iterations = 0;
    /// The faster near-null space; the seconds are those with it.
    NearNullSpace near_null_space = NearNullSpace::rigid_body_modes;

    /// The sum of the three times [s].
    double
    seconds() const
    {
      return seconds_assembly + seconds_preconditioner + seconds_krylov;
    }
  };

  /// Assemble, set up the multigrid method and solve by CG, from scratch, with each near-null
  /// space, and take the minimum of each figure. Replaces the stiffness matrix by one of the same
  /// values: references to the old one become invalid. Collective.
  /// @param tolerance of the residual, relative to the load
  template <int dim>
  LinearReference
  solve_without_contact(Elasticity<dim>            &elasticity,
                        const LinearSolverSettings &settings,
                        double                      tolerance);
} // namespace Signorini
