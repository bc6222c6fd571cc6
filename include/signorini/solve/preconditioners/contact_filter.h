#pragma once

#include <signorini/solve/preconditioner.h>
#include <signorini/solve/zone_solver.h>

namespace Signorini
{
  /// F-V-F: an exact solve on the degrees of freedom that contact touches (F), one V-cycle of the
  /// multigrid method for K alone (V), F again. The hierarchy of K never changes; the stiff contact
  /// terms, or the constraints in a saddle point system, are seen by F only, so that the iteration
  /// count depends neither on the penalty nor on the size of the mesh. One V-cycle an application.
  class ContactFilter : public Preconditioner
  {
  public:
    ContactFilter(const ContactSystem &system, const AMG &amg, const std::string &direct_solver);

    void
    update() override;

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    bool
    is_positive_definite() const override
    {
      return false;
    }

  private:
    const ContactSystem        &system;
    const AMG                  &amg;
    const std::string           direct_solver;
    std::unique_ptr<ZoneSolver> zone; ///< what active contact touches
    mutable LA::BlockVector     residual;
    mutable LA::Vector          correction;
  };
} // namespace Signorini
