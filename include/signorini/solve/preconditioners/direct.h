#pragma once

#include <signorini/solve/preconditioner.h>
#include <signorini/solve/zone_solver.h>

namespace Signorini
{
  /// Factorisation of the whole system: for small problems and as a reference.
  class Direct : public Preconditioner
  {
  public:
    Direct(const ContactSystem &system, const std::string &direct_solver);

    void
    update() override;

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    bool
    is_positive_definite() const override
    {
      return false;
    }

    bool
    is_exact() const override
    {
      return true;
    }

  private:
    ZoneSolver all;
  };
} // namespace Signorini
