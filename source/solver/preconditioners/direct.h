// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/interface_solver.h"
#include "solver/preconditioner.h"

namespace Signorini
{
  /// Factorisation of the whole system: for small problems and as a reference.
  class Direct : public Preconditioner
  {
  public:
    Direct(const ContactSystem &system, LA::DirectLibrary direct_solver);

    void
    update() override;

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    bool
    is_positive_definite() const override
    {
      return false;
    }

    /// Springs against unconstrained rigid-body modes are in the factors, but not in the system;
    /// how forces change as surfaces move is in the system, but not in the factors.
    bool
    is_exact() const override
    {
      return system.unconstrained_modes().empty() && system.gap_operator().at_rest();
    }

    bool
    preserves_constraints() const override
    {
      return true;
    }

    void
    start(LA::BlockVector &x, const LA::BlockVector &rhs) const override;

  private:
    const ContactSystem &system;
    InterfaceSolver      all;
  };
} // namespace Signorini
