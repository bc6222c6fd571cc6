// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/constraints/gap_operator.h"
#include "contact/laws/contact_status.h"
#include "solver/contact_system.h"
#include "solver/newton_report.h"

#include <set>
#include <string>

namespace Signorini
{
  /// The active set: the statuses of the contact points. Closed (active) points are those where the
  /// law has a pressure; points of pairs without separation are always closed. Stores the history
  /// that Newton's method needs: the statuses of the last step, earlier sets, and how often each
  /// point has changed.
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

    /// Number of closed points of pairs with separation.
    unsigned int
    n_active_unilateral() const;

    /// Keep the set, but clear the history.
    void
    restart();

    /// Start from these statuses; points of pairs without separation become closed. Returns true if
    /// the set differs from the present one. Collective.
    bool
    set(const LA::Vector &status);

    /// Set the statuses that the contact law implies; the present ones become those of the last
    /// step. Collective.
    void
    update(const LA::Vector &status);

    /// Let slipping points stick for this step, where there is friction, if their tangential
    /// traction turns by more than a right angle for the second time since restart(): stick is
    /// between the two, and they would else jump from one side of the disc to the other for ever.
    /// No effect on laws without friction.
    /// @param trial trial traction of the law
    /// @param traction of the last step
    void
    stick_where_traction_turns(const PointVectors &trial, const PointVectors &traction);

    /// Let the slipping points of each pair stick whose trial traction, relative to the bound of
    /// friction, is least. Returns their number. Collective.
    /// @param trial trial traction of the law
    /// @param share 1: all below the mean of their pair; 0: the least only
    unsigned int
    stick_least_loaded(const PointVectors &trial, double share);

    /// Of the points that stuck and would slip, let only those slip, in each pair, whose trial
    /// traction relative to the bound of friction is at least the mean of them. Collective.
    /// @param trial trial traction of the law
    void
    slip_most_loaded(const PointVectors &trial);

    /// Where points that stuck begin to slip, let slip spread over the sticking points around, ring
    /// by ring, as far as these cannot bear what exceeds the bound at the ones that begin. Left to
    /// the point-wise law, the zone of slip of a thin body grows by a few points a step.
    /// Collective.
    /// @param trial trial traction of the law
    /// @param traction of the points; where slip spreads to, set to the bound in the direction of
    /// the excess
    void
    spread_slip(const PointVectors &trial, PointVectors &traction);

    /// Let points that begin to slip take their neighbours along, where that has gone on for
    /// several steps in a pair without others that return (doc/theory, 4.5). Collective.
    /// @param trial traction of the law
    /// @param traction of the points; at the neighbours set to the bound
    void
    hasten_slip(const PointVectors &trial, PointVectors &traction);

    /// Let the points that close stick for this step, where there is friction. Collective.
    void
    stick_where_closing();

    /// Let points that have opened and closed several times close with the other kind of status,
    /// slip or stick, every second time. Collective.
    void
    alternate_kinds_of_chattering_points();

    /// Let the points that were and are closed keep the kind of their status, slip or stick.
    /// Returns true if that changes the set. Collective.
    bool
    keep_kinds();

    /// Restrict the newly active points of each pair to those with at least half of the deepest
    /// penetration. Where smooth bodies penetrate each other, the contact area is only a part of
    /// the area of penetration; in Hertz' contact it is exactly that one. Returns the number of
    /// active points. Collective.
    /// @param step_by_step also restrict the number of active points to about four times that of
    /// the last set
    unsigned int
    restrict_to_deepest(const LA::Vector &gap, bool step_by_step = false);

    /// Deactivate connected regions of points whose mean trial pressure is tensile, together with
    /// the points beside them that penetrate only because the region was rotated. Left to the
    /// point-wise law, the edge of such a region would move along a plate that lifts off by one
    /// point a step. A pair of which no active point would remain is left unchanged.
    /// @param trial normal component of the trial traction of the law
    void
    deactivate_tensile_regions(const LA::Vector &trial);

    /// Activate all points with zero gap (initial contact carries load). Returns the number of
    /// active points. Collective.
    unsigned int
    activate_zero_gap(const LA::Vector &gap);

    /// Deactivate points with zero gap: all points of pairs with separation if at most one of them
    /// penetrates, else restrict_to_deepest(). A body that only contact supports, or an obstacle
    /// under a given force, would otherwise rest on a single point at first; it is better pushed in
    /// a little before that point becomes active. Returns the number of active points. Collective.
    unsigned int
    deactivate_zero_gap(const LA::Vector &gap);

    /// Undo all openings and closures but that of the point that violates the law most. Collective.
    /// @param trial normal component of the trial traction of the law
    void
    change_only_most_violated(const LA::Vector &trial);

    /// Undo all changes if the last set has an active point of a pair with separation. Returns true
    /// if that changes anything. Collective.
    bool
    restore_previous_if_active();

    /// Replace a set without active points of pairs with separation by these statuses. Returns true
    /// if it has such points then. Collective.
    bool
    replace_if_empty(const LA::Vector &status);

    /// True if the set has occurred before since restart(), other than in the last step.
    /// Collective.
    bool
    is_cycling();

    /// Numbers of points.
    struct Changes
    {
      unsigned int all        = 0; ///< whose status differs from that of the last step
      unsigned int of_contact = 0; ///< those among them that open or close
    };

    /// Count the changes since the last step, and add them to those of each point. Collective.
    Changes
    count_changes();

    /// Indicator of chattering points: 1 at the contact points that changed often.
    LA::Vector
    chattering() const;

    /// The positions of the chattering points, for messages. Collective.
    std::string
    chattering_points() const;

  private:
    /// The rounding error of coordinates [length]: smaller penetrations are insignificant.
    double
    coordinate_rounding() const;

    // Statuses of the present and the last step, and the number of changes of each point.
    const GapOperator &contact;
    LA::Vector         now, last, changes;
    // How often tractions have turned since restart() or since the points stuck.
    LA::Vector turns;
    // For each pair in how many successive steps points have begun to slip without others that
    // returned.
    std::vector<unsigned int> advances;
    // Number of bilateral points on all ranks.
    const unsigned int n_bilateral;
    // Hash values of the sets since restart().
    std::set<uint64_t> history;
  };

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
    /// @param in gaps, stresses and tractions
    /// @param traction those of `in`; changed where slip spreads
    /// @param n number of the step
    /// @param was_idle the last step changed nothing
    /// @param step gets the counts
    bool
    update(
      const LawInputs &in, PointVectors &traction, unsigned int n, bool was_idle, NewtonStep &step);

    /// Values of ContactStatus of the present set.
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

    /// The present set with its history.
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
    /// Let points stick if slipping ones leave bodies without constraint that friction has to hold.
    /// Returns true if that changes the set. Collective.
    bool
    hold_bodies(const PointVectors &trial);

    ContactSystem     &system;
    ContactLaw        &law;
    const GapOperator &contact;
    const double       first_reduction;
    ActiveSet          active_set;
    bool               is_cold      = true; ///< started without a pressure
    bool               globalised   = false;
    double             my_reduction = 1e-2;
    unsigned int n_changes = 0; ///< steps that changed the set, since the strategy changed last
    unsigned int n_holds   = 0; ///< steps in which hold_bodies() has changed the set
  };
} // namespace Signorini
