// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/active_set.h"
#include "solver/contact_system.h"
#include "solver/newton_report.h"

namespace Signorini
{
  /// The active-set strategy: which points are active in the next Newton step. Mostly those that
  /// the law implies, with globalisation where that fails:
  /// a cold start, without a pressure to start from, takes only the deepest half of the penetrating
  /// points, lets the set grow step by step, and scales stiff penalties down until the set is
  /// nearly found (penalty continuation);
  /// a set that cycles, or keeps changing, is first left to more accurate linear solves, and then
  /// needs globalisation: one change at a time where pressures are unknowns, a line search
  /// elsewhere.
  class ActiveSetStrategy
  {
  public:
    /// Keeps references to both. The system is used to find the rigid-body modes that a set leaves
    /// unconstrained; its matrices are not changed.
    ActiveSetStrategy(ContactSystem &system, ContactLaw &law, double reduction);

    /// Start a new solution. Returns true if the set, or the penalty of the law, is not that of the
    /// last one. Collective.
    /// @param p pressure
    /// @param status initial statuses
    bool
    start(const LA::Vector &p, const LA::Vector &status);

    /// Start the next augmentation.
    void
    restart();

    /// Determine the statuses of the next step. Returns true if the linearisation is not that of
    /// the last step. Collective.
    /// @param n number of the step
    /// @param was_idle the last step changed nothing
    /// @param step gets the counts
    bool
    update(const LawInputs &in, unsigned int n, bool was_idle, NewtonStep &step);

    const LA::Vector &
    status() const
    {
      return active_set.values();
    }

    /// True if full steps have failed to find the set, so that steps need a line search, or change
    /// one point at a time.
    bool
    needs_globalisation() const
    {
      return globalised;
    }

    /// The reduction of the residual by linear solves while the set changes (forcing term).
    double
    reduction() const
    {
      return my_reduction;
    }

    const ActiveSet &
    set() const
    {
      return active_set;
    }

  private:
    /// True if no point of a pair with separation has a pressure. Collective.
    bool
    has_no_pressure(const LA::Vector &p) const;
    /// True if the points with zero gap constrain all rigid-body modes that contact can constrain
    /// at all: true for a stack of blocks, false for a ball on a plane. Collective.
    bool
    zero_gaps_constrain_all_modes(const LA::Vector &gap);

    ContactSystem     &system;
    ContactLaw        &law;
    const GapOperator &contact;
    const double       first_reduction;
    ActiveSet          active_set;
    bool               is_cold      = true; ///< started without a pressure
    bool               globalised   = false;
    double             my_reduction = 1e-2;
    unsigned int n_changes = 0; ///< steps that changed the set, since the strategy changed last
  };
} // namespace Signorini
