// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/contact_system.h"
#include "solver/preconditioners/amg.h"

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  struct LinearSolverSettings;

  /// An approximation of the Schur complement S = C B K^-1 B^T A + I of a saddle point (doc/theory,
  /// (7.12)), which is positive definite if the law is symmetric, C = A. Each approximation is a
  /// class in the source file with an entry of the registry there.
  class SchurComplement
  {
  public:
    virtual ~SchurComplement() = default;

    /// Recompute the approximation after the system has changed. Collective.
    virtual void
    update() = 0;

    /// dst = S^-1 src in the blocks of the multipliers; the displacement blocks are not defined
    /// afterwards. Collective.
    virtual void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const = 0;

    /// True if the approximation is a fixed symmetric positive definite operator, as MINRES
    /// requires.
    virtual bool
    is_linear() const
    {
      return true;
    }

    /// The approximation that the settings name.
    /// @param system saddle point system; it and `amg` must exist as long as the result
    static std::unique_ptr<SchurComplement>
    create(const LinearSolverSettings &settings, const ContactSystem &system, const AMG &amg);

    /// The names of all approximations, as the settings use them.
    static std::vector<std::string>
    names();
  };
} // namespace Signorini
