// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/stiffness.h"
#include "solver/volumetric_equations.h"

#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// The solids without contact, at a given time: the residual of their equilibrium and its
  /// linearisation. Displacements satisfy the constraints.
  class SolidResidual
  {
  public:
    virtual ~SolidResidual() = default;

    /// Set the external forces. @param f as Elasticity provides it for this kind of solids
    virtual void
    set_load(LA::Vector f) = 0;

    /// Announce that the next displacement differs from the solution u by new values of
    /// constraints. Where that is too far for Newton's method, residual() and linearise() use the
    /// linearisation at u for the next displacement, once.
    virtual void
    extrapolate_from(const LA::Vector & /*u*/)
    {}

    /// The residual f - F(u): external minus internal forces. Constrained components are undefined.
    /// Collective.
    virtual LA::Vector
    residual(const LA::Vector &u) const = 0;

    /// The norm of the external forces, including those due to prescribed displacements: residuals
    /// are measured against it.
    virtual double
    load_size() const = 0;

    /// The norm of the forces that the rounding of the deformation gradient makes, where nothing is
    /// applied to the bodies (no loads, pressures or temperatures); else 0.
    virtual double
    rounding_without_loads() const
    {
      return 0;
    }

    /// The largest load_size() so far, if the rounding error of later ones is relative to it; else
    /// 0. Not collective.
    virtual double
    largest_load() const
    {
      return 0;
    }

    /// True if residual() is not linear about u. False while it uses a linearisation, see
    /// extrapolate_from().
    virtual bool
    is_nonlinear() const
    {
      return false;
    }

    /// Linearise at u: stiffness() is that at u from then on. Its version changes if its values
    /// have changed. Collective.
    virtual void
    linearise(const LA::Vector &u) = 0;

    /// The largest admissible step length in (0, 1] for the increment du from u. Throws
    /// SolverFailure if there is none. Collective.
    virtual double
    largest_admissible_step(const LA::Vector & /*u*/, const LA::Vector & /*du*/) const
    {
      return 1;
    }

    /// The tangent dF/du, with a stabilisation of unconstrained rigid-body modes (see
    /// UnconstrainedModes) that F does not contain.
    virtual const Stiffness &
    stiffness() const = 0;

    /// True if dF/du is symmetric.
    virtual bool
    is_symmetric() const
    {
      return true;
    }

    /// The equations of the volumetric stress, linearised by linearise(); null if no body is in
    /// displacement-pressure form.
    virtual VolumetricEquations *
    volumetric() const
    {
      return nullptr;
    }

    /// VolumetricEquations::coefficients(); empty if no body is mixed.
    LA::Vector
    volumetric_stress() const
    {
      return volumetric() ? volumetric()->coefficients() : LA::Vector();
    }

    /// The constraints of the displacement: hanging nodes, supports, and prescribed motions.
    virtual const dealii::AffineConstraints<double> &
    constraints() const = 0;

    /// The body of each locally owned degree of freedom.
    virtual const std::vector<unsigned int> &
    body_of_dof() const = 0;
  };

  /// Linear elasticity: F = K u + B^T m. The version of the stiffness never changes.
  class LinearElasticSolid : public SolidResidual
  {
  public:
    /// Keeps a reference to the constraints.
    /// @param stabilisation the diagonal that K contains to stabilise unconstrained rigid-body
    /// modes; empty: none
    /// @param volumetric null: no body is in displacement-pressure form
    LinearElasticSolid(std::unique_ptr<const Stiffness>         K,
                       const LA::Vector                        &stabilisation,
                       const dealii::AffineConstraints<double> &constraints,
                       std::vector<unsigned int>                body_of_dof,
                       std::unique_ptr<VolumetricEquations>     volumetric = nullptr);

    /// @param f with prescribed displacements eliminated, Elasticity::load()
    void
    set_load(LA::Vector f) override;

    LA::Vector
    residual(const LA::Vector &u) const override;

    double
    load_size() const override
    {
      return f.l2_norm();
    }

    void
    linearise(const LA::Vector & /*u*/) override
    {}

    const Stiffness &
    stiffness() const override
    {
      return *K;
    }

    VolumetricEquations *
    volumetric() const override
    {
      return my_volumetric.get();
    }

    const dealii::AffineConstraints<double> &
    constraints() const override
    {
      return my_constraints;
    }

    const std::vector<unsigned int> &
    body_of_dof() const override
    {
      return bodies;
    }

  private:
    std::unique_ptr<const Stiffness>         K;
    std::unique_ptr<VolumetricEquations>     my_volumetric;
    const LA::Vector                         stabilisation;
    const dealii::AffineConstraints<double> &my_constraints;
    const std::vector<unsigned int>          bodies;
    LA::Vector                               f;
  };
} // namespace Signorini
