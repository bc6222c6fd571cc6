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

  /// A preconditioner of the contact system: a file pair in solver/preconditioners and a line in
  /// the registry. Each is applicable to both forms of the system.
  class Preconditioner
  {
  public:
    virtual ~Preconditioner() = default;

    /// Adapt to the present active set and its linearisation. Collective.
    virtual void
    update() = 0;

    /// Set the start vector of Krylov methods, where the preconditioner relies on a special one.
    /// @param x in: zero
    virtual void
    start([[maybe_unused]] LA::BlockVector &x, [[maybe_unused]] const LA::BlockVector &rhs) const
    {}

    /// Apply the preconditioner: dst = M^-1 src. Collective.
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

    /// Make the preconditioner that the settings name.
    /// @param settings with a direct solver chosen
    /// @param interface_includes_geometric of an interface multigrid, see InterfaceSolver
    static std::unique_ptr<Preconditioner>
    create(const LinearSolverSettings &settings,
           const ContactSystem        &system,
           const Hierarchy            *hierarchy,
           bool                        interface_includes_geometric);
  };

  /// The names of all preconditioners, for the key Solver/Preconditioner.
  std::vector<std::string>
  preconditioner_names();
} // namespace Signorini
