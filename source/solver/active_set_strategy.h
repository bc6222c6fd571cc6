// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solver/active_set.h"
#include "solver/contact_system.h"
#include "solver/newton_report.h"

namespace Signorini
{
  /// Which points are taken for active next. Mostly those that the law says; but a cold start, from
  /// no pressure, takes the deepest half of what overlaps, grows step by step, and softens stiff
  /// penalties until the set is nearly found; and a set that comes up again, or that keeps
  /// changing, is left by finer linear solves, and then by caution: one change at a time where
  /// pressures are unknowns, small steps elsewhere.
  class ActiveSetStrategy
  {
  public:
    /// Refers to both. The system finds the motions that a set leaves loose; its matrices stay.
    ActiveSetStrategy(ContactSystem &system, ContactLaw &law, double reduction);

    /// A new solution. Returns true if the set, or the stiffness of the law, is not that of the
    /// last one. Collective.
    /// @param p pressure
    /// @param status what it starts with
    bool
    start(const LA::Vector &p, const LA::Vector &status);

    /// The next augmentation.
    void
    restart();

    /// Returns true if the linearisation is not that of the last step. Collective.
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

    /// Steps have to be safe now rather than full.
    bool
    needs_globalisation() const
    {
      return globalised;
    }

    /// By linear solves while the set changes.
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
    /// At points that may separate.
    bool
    has_no_pressure(const LA::Vector &p) const;
    /// What touches at the start holds all that contact could hold: so does a stack of blocks, a
    /// ball on a plane does not.
    bool
    zero_gaps_constrain_all_modes(const LA::Vector &gap);

    ContactSystem     &system;
    ContactLaw        &law;
    const GapOperator &contact;
    const double       first_reduction;
    ActiveSet          active_set;
    bool               is_cold      = true; ///< without a pressure to start from
    bool               globalised   = false;
    double             my_reduction = 1e-2;
    unsigned int n_changes = 0; ///< steps that changed the set, since something else was tried
  };
} // namespace Signorini
