// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/contact_system.h"
#include "solver/preconditioners/hierarchy.h"

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  struct LinearSolverSettings;

  /// A preconditioner of the contact system: one file pair under solve/preconditioners and one line
  /// in the registry. Each serves both forms of the system.
  class Preconditioner
  {
  public:
    virtual ~Preconditioner() = default;

    /// To be called when the active set has changed. Collective.
    virtual void
    update() = 0;

    /// Set the start vector of Krylov methods, where the preconditioner relies on a special one.
    /// @param x in: zero
    virtual void
    start(LA::BlockVector & /*x*/, const LA::BlockVector & /*rhs*/) const
    {}

    virtual void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const = 0;

    /// True if the preconditioner is symmetric and positive definite on saddle point systems too,
    /// as MINRES requires. (On condensed systems all are.)
    virtual bool
    is_positive_definite() const = 0;

    /// True if CG can be used on saddle points: applied to residuals that satisfy the constraints,
    /// the preconditioner yields vectors that satisfy them, and is symmetric and positive definite
    /// among these.
    virtual bool
    preserves_constraints() const
    {
      return false;
    }

    /// Number of multigrid cycles so far.
    virtual unsigned int
    multigrid_cycles() const
    {
      return 0;
    }

    /// True if one application solves the system.
    virtual bool
    is_exact() const
    {
      return false;
    }

    /// @param settings with a direct solver chosen
    /// @param interface_includes_geometric of an interface multigrid, see InterfaceSolver
    static std::unique_ptr<Preconditioner>
    create(const LinearSolverSettings &settings,
           const ContactSystem        &system,
           const Hierarchy            *hierarchy,
           bool                        interface_includes_geometric);
  };

  std::vector<std::string>
  preconditioner_names();
} // namespace Signorini
