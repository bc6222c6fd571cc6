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

  /// An approximation of the Schur complement S = C B K^-1 B^T A + I of a saddle point, which is
  /// positive definite if the law is symmetric, C = A. One class in the source file and one line in
  /// the registry there.
  class SchurComplement
  {
  public:
    virtual ~SchurComplement() = default;

    /// To be called when the system has changed. Collective.
    virtual void
    update() = 0;

    /// dst = S^-1 src in the blocks of the multipliers of two vectors of the system.
    virtual void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const = 0;

    /// True if it is a fixed symmetric positive definite operator, as MINRES requires.
    virtual bool
    is_linear() const
    {
      return true;
    }

    static std::unique_ptr<SchurComplement>
    create(const LinearSolverSettings &settings, const ContactSystem &system, const AMG &amg);

    static std::vector<std::string>
    names();
  };
} // namespace Signorini
