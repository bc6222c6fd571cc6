// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/stiffness.h"
#include "solver/volumetric_equations.h"

#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// The bodies without contact, at a time, as Newton's method sees them: what is out of balance at
  /// a displacement, and the linearisation there. Displacements satisfy the constraints.
  class SolidResidual
  {
  public:
    virtual ~SolidResidual() = default;

    /// What acts on the bodies from now on. @param f as Elasticity has it for this kind of bodies
    virtual void
    set_load(LA::Vector f) = 0;

    /// The next displacement differs from this one, which was a solution, by new values of
    /// constraints: where that is too far for Newton's method, residual() and linearise() extend it
    /// by the linearisation there, once.
    virtual void
    extrapolate_from(const LA::Vector & /*u*/)
    {}

    /// f - F(u): the loads of now minus the forces of deformation. Constrained components mean
    /// nothing.
    virtual LA::Vector
    residual(const LA::Vector &u) const = 0;

    /// Size of the loads, those of prescribed displacements included: residuals are small beside
    /// that.
    virtual double
    load_size() const = 0;

    /// The largest load_size() so far where that tells what is rounding of later ones, else 0; not
    /// collective.
    virtual double
    largest_load() const
    {
      return 0;
    }

    /// Does residual() differ from its linearisation at u? Not where it extends one, see
    /// extrapolate_from().
    virtual bool
    is_nonlinear() const
    {
      return false;
    }

    /// Linearise at u: stiffness() is that of u from then on. Its version tells whether anything
    /// has changed. Collective.
    virtual void
    linearise(const LA::Vector &u) = 0;

    /// The largest share, up to 1, of a step du from u that Newton's method may take. Throws
    /// SolverFailure if there is none. Collective.
    virtual double
    largest_admissible_step(const LA::Vector & /*u*/, const LA::Vector & /*du*/) const
    {
      return 1;
    }

    /// dF/du, with springs against unconstrained rigid-body modes (see UnconstrainedModes), which F
    /// has not.
    virtual const Stiffness &
    stiffness() const = 0;

    /// False: dF/du is not symmetric.
    virtual bool
    is_symmetric() const
    {
      return true;
    }

    /// Of mixed bodies, at the displacement of linearise(); null if there are none.
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

    virtual const dealii::AffineConstraints<double> &
    constraints() const = 0;

    /// The number of the body of each degree of freedom of this rank.
    virtual const std::vector<unsigned int> &
    body_of_dof() const = 0;
  };

  /// Linear elasticity: F = K u + B^T m, whose version never changes.
  class LinearElasticSolid : public SolidResidual
  {
  public:
    /// Refers to the constraints.
    /// @param stabilisation those that K has against unconstrained rigid-body modes; empty: none
    /// @param volumetric null: no body is mixed
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
