// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/laws/contact_status.h"

#include <set>
#include <string>

namespace Signorini
{
  /// The statuses of the contact points. Closed are those where the law has a pressure, among them
  /// always those of pairs that never separate. With them goes what Newton's method remembers: the
  /// statuses of the step before, sets that were, and how often points have changed.
  class ActiveSet
  {
  public:
    explicit ActiveSet(const GapOperator &contact);

    /// Values of ContactStatus.
    const LA::Vector &
    values() const
    {
      return now;
    }

    /// Number of closed points.
    unsigned int
    size() const;

    /// Without those of pairs that never separate.
    unsigned int
    n_active_unilateral() const;

    /// Keep the set, but forget the way to it.
    void
    restart();

    /// Start from these statuses, and what is always closed. True if they are others. Collective.
    bool
    set(const LA::Vector &status);

    /// The statuses that the contact law asks for; the present ones become the last ones.
    void
    update(const LA::Vector &status);

    /// Where smooth bodies overlap, they are pushed apart on a part of that area only: Hertz' is
    /// where they are at least half as deep as at the deepest point. Of each pair no other points
    /// become active. Returns the number of active points.
    /// @param step_by_step nor so many that there are more than four times those of the last set
    unsigned int
    restrict_to_deepest(const LA::Vector &gap, bool step_by_step = false);

    /// A region of points that pulls as a whole does not stay, nor do the points beside it that
    /// overlap because it was turned about: left to themselves, they would wander along a lever
    /// that lifts off, a point a step. Of each pair something must be left.
    /// @param trial normal component of that of the law: the pressure that points would have
    void
    deactivate_tensile_regions(const LA::Vector &trial);

    /// Bodies that stand on each other do not fall. Returns the number of active points.
    unsigned int
    activate_zero_gap(const LA::Vector &gap);

    /// A body that nothing but contact holds, or an obstacle under a given force, rests on a point
    /// at first; better it is pushed in a little before that point counts. Returns the number of
    /// active points.
    unsigned int
    deactivate_zero_gap(const LA::Vector &gap);

    /// Of all changes, make the one that violates the law most.
    /// @param trial normal component of that of the law
    void
    change_only_most_violated(const LA::Vector &trial);

    /// Take back all changes if there was an active point that may separate. Returns true if that
    /// changes anything.
    bool
    restore_previous_if_active();

    /// Instead of a set without points that may separate. Returns true if it has some then.
    bool
    replace_if_empty(const LA::Vector &status);

    /// True if the set is one of those since restart(), but not the last one.
    bool
    is_cycling();

    /// Number of points whose status is not the last one.
    unsigned int
    count_changes();

    /// 1 at the contact points that changed often.
    LA::Vector
    chattering() const;

    /// Where they are, for messages.
    std::string
    chattering_points() const;

  private:
    /// Surfaces that touch overlap by that, of which nothing follows.
    double
    coordinate_rounding() const;

    const GapOperator &contact;
    LA::Vector         now, last, changes;
    const unsigned int n_bilateral;
    std::set<uint64_t> history;
  };
} // namespace Signorini
