// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/deformation_kernel.h"
#include "solid/elasticity.h"
#include "solid/pressure_kernel.h"
#include "solid/stiffness.h"
#include "solver/solid_residual.h"
#include "solver/volume_constraint.h"

#include <deal.II/base/timer.h>

#include <functional>
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

  /// Solids whose constitutive laws are not all linear elasticity: F(u) = int P(u) : Grad v dV,
  /// minus follower pressures on bodies at finite strain.
  template <int dim>
  class NonlinearSolid : public SolidResidual
  {
  public:
    /// Keeps references to elasticity and timer. Collective.
    /// @param form of the tangent
    NonlinearSolid(StiffnessForm             form,
                   Elasticity<dim>          &elasticity,
                   std::vector<unsigned int> body_of_dof,
                   dealii::TimerOutput      &timer);

    /// @param f Elasticity::load(), of bodies that deform by any amount
    void
    set_load(LA::Vector f) override;

    void
    extrapolate_from(const LA::Vector &u) override;

    /// Throws SolverFailure where cells are folded. Collective.
    LA::Vector
    residual(const LA::Vector &u) const override;

    /// The norm of loads, and of the reactions at the last residual.
    double
    load_size() const override;

    double
    rounding_without_loads() const override;

    /// The largest load_size() so far: bodies may undergo rigid motions without force, and then
    /// reactions are nothing but rounding error.
    double
    largest_load() const override
    {
      return largest;
    }

    bool
    is_nonlinear() const override
    {
      return origin.size() == 0;
    }

    void
    linearise(const LA::Vector &u) override;

    /// Halves the step until no cell is inverted or loses nine tenths of its volume.
    double
    largest_admissible_step(const LA::Vector &u, const LA::Vector &du) const override;

    const Stiffness &
    stiffness() const override
    {
      return linearisation->stiffness();
    }

    bool
    is_symmetric() const override
    {
      return pressures.empty();
    }

    VolumetricEquations *
    volumetric() const override
    {
      return my_volumetric.get();
    }

    const dealii::AffineConstraints<double> &
    constraints() const override
    {
      return elasticity.constraints();
    }

    const std::vector<unsigned int> &
    body_of_dof() const override
    {
      return bodies;
    }

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Calls visit(cell, indices) for the locally owned cells.
    void
    for_cells(const std::function<void(const Cell                                         &cell,
                                       const std::vector<dealii::types::global_dof_index> &indices)>
                &visit) const;
    LA::Vector
    forces(const LA::Vector &u) const;
    /// The norm of the forces of thermal strain of bodies with a constitutive law. Collective.
    double
    size_of_thermal_forces() const;
    /// The norm of E V/h of the cells, over their degrees of freedom, times the rounding of one.
    /// Collective.
    double
    size_of_rounding() const;
    /// Throws SceneError where a pressure is not a number. Collective.
    void
    check_pressures() const;

    const Elasticity<dim>                       &elasticity;
    const std::vector<unsigned int>              bodies;
    dealii::TimerOutput                         &timer;
    const std::unique_ptr<VolumeConstraint<dim>> my_volumetric; ///< null: no body is mixed
    LA::Vector                                   f;
    LA::Vector                                   origin; ///< see extrapolate_from(); empty: none
    LA::Vector                                   linearised; ///< where; empty: nowhere
    /// Their versions there.
    unsigned int linearised_volumetric = 0, linearised_history = 0, linearised_thermal = 0;
    mutable DeformationKernel<dim>            kernel;
    mutable PressureKernel<dim>               pressures;
    const std::unique_ptr<Linearisation<dim>> linearisation;
    double                                    thermal_size = 0; ///< see size_of_thermal_forces()
    double         rounding_of_strain;          ///< norm of forces, see rounding_without_loads()
    mutable double reaction = 0, following = 0; ///< sizes, of reactions and pressures
    mutable double largest = 0;                 ///< load_size() so far
  };
} // namespace Signorini
