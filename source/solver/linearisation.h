// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/deformation_kernel.h"
#include "solid/elasticity.h"
#include "solid/pressure_kernel.h"
#include "solid/stiffness.h"

#include <memory>

namespace Signorini
{
  /// The derivative of the forces of bodies that deform by any amount, pressures that follow them
  /// included, as a Stiffness.
  template <int dim>
  class Linearisation
  {
  public:
    /// Refers to all but the form. Collective.
    static std::unique_ptr<Linearisation>
    create(StiffnessForm           form,
           Elasticity<dim>        &elasticity,
           DeformationKernel<dim> &kernel,
           PressureKernel<dim>    &pressures);

    virtual ~Linearisation() = default;

    /// Linearise at u. Throws SolverFailure where cells are folded: then the stiffness means
    /// nothing. Collective.
    /// @param u with ghosts, satisfies the constraints
    virtual void
    linearise(const LA::Vector &u) = 0;

    /// Of the bodies at rest, before they are linearised.
    virtual const Stiffness &
    stiffness() const = 0;
  };
} // namespace Signorini
