// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/preconditioner.h"

namespace Signorini
{
  /// Block triangular preconditioner for systems with a volumetric stress m: first m by the
  /// diagonal S of the Schur complement, then displacement and multipliers by another
  /// preconditioner P that does not involve m,
  ///
  ///     m = -S^-1 r_m,   (u, q) = P (r_u - B^T m, r_q)
  ///
  /// (Murphy, Golub, Wathen, SIAM J. Sci. Comput. 21 (2000) 1969; doc/theory, 7.7). S is as good
  /// for any lambda, because B K^-1 B^T is spectrally equivalent to int phi phi/(2 mu) in a stable
  /// pair (Elman, Silvester, Wathen, Finite Elements and Fast Iterative Solvers, 2014, 3.5).
  class VolumetricSchur : public Preconditioner
  {
  public:
    /// @param system,volumetric must exist as long as this object
    /// @param others preconditioner P of the displacement and the multipliers
    VolumetricSchur(const ContactSystem            &system,
                    const VolumetricCoupling       &volumetric,
                    std::unique_ptr<Preconditioner> others);

    void
    update() override
    {
      others->update();
    }

    void
    start(LA::BlockVector &x, const LA::BlockVector &rhs) const override
    {
      others->start(x, rhs);
    }

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    bool
    is_positive_definite() const override
    {
      return false;
    }

    unsigned int
    multigrid_cycles() const override
    {
      return others->multigrid_cycles();
    }

  private:
    const VolumetricCoupling             &volumetric;
    const std::unique_ptr<Preconditioner> others;
    mutable LA::BlockVector               rest;
  };
} // namespace Signorini
