// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

namespace Signorini
{
  /// The linearised equations of the volumetric stress m of bodies in displacement-pressure form,
  /// which are coupled with those of the displacement u:
  ///
  ///     [ K   B^T ] [du]
  ///     [ B   -C  ] [dm]
  ///
  /// B = int phi_i dtheta/du, C = int phi_i phi_j/lambda, see VolumetricStress.
  struct VolumetricCoupling
  {
    LA::SparseMatrix B;     ///< zero in the columns of constrained degrees of freedom
    LA::SparseMatrix C;     ///< diagonal where functions are orthogonal
    LA::Vector       schur; ///< approximation of the diagonal of C + B K^-1 B^T, for any lambda
  };

  /// The equations of the volumetric stress, which Newton's method updates together with the
  /// displacement.
  class VolumetricEquations
  {
  public:
    virtual ~VolumetricEquations() = default;

    /// See SolidResidual::extrapolate_from().
    virtual void
    extrapolate_from(const LA::Vector &u) = 0;

    /// The right-hand side of a step, C m - int phi theta(u) [force]. Constraints are applied to u
    /// where it does not satisfy them. Throws SolverFailure where cells are inverted. Collective.
    virtual LA::Vector
    residual(const LA::Vector &u) const = 0;

    /// See SolidResidual::linearise(). Collective.
    virtual void
    linearise(const LA::Vector &u) = 0;

    /// m, VolumetricStress::coefficients().
    virtual LA::Vector
    coefficients() const = 0;

    /// Add factor dm to m. Collective.
    virtual void
    add(double factor, const LA::Vector &dm) = 0;

    /// r -= B^T m, the forces of m where they are linear in it.
    virtual void
    subtract_forces(LA::Vector &r) const = 0;

    /// The coupling as of the last linearise(); the reference stays valid.
    virtual const VolumetricCoupling &
    coupling() const = 0;

    /// Changes with each add().
    virtual unsigned int
    version() const = 0;
  };
} // namespace Signorini
