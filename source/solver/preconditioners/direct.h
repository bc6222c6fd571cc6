#pragma once

#include "solver/preconditioner.h"
#include "solver/zone_solver.h"

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

    /// Springs against free motions are in the factors, but not in the system; how forces change as
    /// surfaces move is in the system, but not in the factors.
    bool
    is_exact() const override
    {
      return system.free_motions().empty() && system.gap_operator().at_rest();
    }

    bool
    keeps_constraints() const override
    {
      return true;
    }

    void
    start(LA::BlockVector &x, const LA::BlockVector &rhs) const override;

  private:
    const ContactSystem &system;
    ZoneSolver           all;
  };
} // namespace Signorini
