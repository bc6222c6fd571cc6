// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/deformation_kernel.h"
#include "solid/elasticity.h"
#include "solid/pressure_kernel.h"
#include "solid/stiffness.h"

#include <memory>

namespace Signorini
{
  /// The tangent stiffness of solids at finite strain, including follower pressures, as a
  /// Stiffness.
  template <int dim>
  class Linearisation
  {
  public:
    /// Keeps references to all arguments but the form. Collective.
    static std::unique_ptr<Linearisation>
    create(StiffnessForm           form,
           Elasticity<dim>        &elasticity,
           DeformationKernel<dim> &kernel,
           PressureKernel<dim>    &pressures);

    virtual ~Linearisation() = default;

    /// Linearise at u. Throws SolverFailure where cells are inverted; then the stiffness is
    /// undefined. Collective.
    /// @param u with ghosts, satisfies the constraints
    virtual void
    linearise(const LA::Vector &u) = 0;

    /// The tangent stiffness at the last linearise(); before, that of the undeformed bodies.
    virtual const Stiffness &
    stiffness() const = 0;
  };
} // namespace Signorini
