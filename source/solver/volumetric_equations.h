// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/types.h"

namespace Signorini
{
  /// The linearised equations of the volumetric stress m of mixed bodies, which join those of their
  /// displacement u:
  ///
  ///     [ K   B^T ] [du]
  ///     [ B   -C  ] [dm]
  ///
  /// B = int phi dtheta/du, C = int phi phi/lambda, see VolumetricStress.
  struct VolumetricCoupling
  {
    LA::SparseMatrix B;          ///< zero in the columns of constrained degrees of freedom
    LA::Vector       compliance; ///< the diagonal of C, which is all that it has
    LA::Vector       schur;      ///< about that of C + B K^-1 B^T, whatever lambda is
  };

  /// What Newton's method asks of the volumetric stress, which it moves as it moves the
  /// displacement.
  class VolumetricEquations
  {
  public:
    virtual ~VolumetricEquations() = default;

    /// See SolidResidual::extrapolate_from().
    virtual void
    extrapolate_from(const LA::Vector &u) = 0;

    /// The right-hand side of a step, C m - int phi theta(u) [force]. Displacements that do not
    /// obey constraints are made to. Throws SolverFailure where cells are folded. Collective.
    virtual LA::Vector
    residual(const LA::Vector &u) const = 0;

    /// See SolidResidual::linearise(). Collective.
    virtual void
    linearise(const LA::Vector &u) = 0;

    /// m, VolumetricStress::coefficients().
    virtual LA::Vector
    coefficients() const = 0;

    /// Add a step of them. Collective.
    virtual void
    add(double factor, const LA::Vector &dm) = 0;

    /// r -= B^T m, the forces of m where they are linear in it.
    virtual void
    subtract_forces(LA::Vector &r) const = 0;

    /// As linearise() has left it; the place stays.
    virtual const VolumetricCoupling &
    coupling() const = 0;

    /// Another one after each add().
    virtual unsigned int
    version() const = 0;
  };
} // namespace Signorini
