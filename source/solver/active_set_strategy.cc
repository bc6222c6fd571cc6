// SPDX-License-Identifier: Apache-2.0
#include "solver/active_set.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Reduction of residuals by linear solves after an active set has recurred.
    constexpr double fine_reduction = 1e-6;
    /// Number of steps of a start without contact pressure in which the active set may grow step by
    /// step, see ActiveSet::restrict_to_deepest().
    constexpr unsigned int steps_of_growth = 5;
    /// Number of steps that change the set before another strategy is used.
    constexpr unsigned int patience = 10;
  } // namespace



  ActiveSetStrategy::ActiveSetStrategy(ContactSystem &system,
                                       ContactLaw    &law,
                                       const double   reduction)
    : system(system)
    , law(law)
    , contact(law.gap_operator())
    , first_reduction(reduction)
    , active_set(contact)
  {}



  // Start a solution. It is a cold start if no unilateral point has a pressure; then stiff
  // penalties are scaled down (penalty continuation, doc/theory, 4.5). Returns true if set or
  // penalty differ from the last linearisation. Collective.
  bool
  ActiveSetStrategy::start(const LA::Vector &p, const LA::Vector &status)
  {
    restart();
    my_reduction              = first_reduction;
    is_cold                   = has_no_pressure(p);
    const bool is_another_set = active_set.set(status);
    const bool is_stiffer     = law.scale_penalty(is_cold ? law.minimal_penalty_scale() : 1);
    return is_another_set || is_stiffer;
  }



  void
  ActiveSetStrategy::restart()
  {
    globalised = false;
    n_changes  = 0;
    n_holds    = 0;
    active_set.restart();
  }



  // Pressures of bilateral points do not count: they are closed anyway.
  bool
  ActiveSetStrategy::has_no_pressure(const LA::Vector &p) const
  {
    double largest = 0;
    for (const auto i : p.locally_owned_elements())
      if (contact.coefficients.least_status(i) == 0)
        largest = std::max(largest, std::abs(p(i)));
    return Utilities::MPI::max(largest, system.stiffness().communicator()) == 0;
  }



  // The active set of the next step (doc/theory, 4.4 and 4.5): that of the law, restricted on a
  // cold start, without tensile regions, and with escalation if it does not settle. Returns true if
  // the linearisation of the contact terms has changed. Collective.
  bool
  ActiveSetStrategy::update(const LawInputs   &in,
                            PointVectors      &traction,
                            const unsigned int n,
                            const bool         was_idle,
                            NewtonStep        &step)
  {
    // The set that the law implies. With a pressure from an earlier solution or mesh, its first set
    // follows from that.
    // (4.8) in the first step from known pressures, (4.7) otherwise.
    const PointVectors trial  = n == 0 && !is_cold ? law.trial_from_traction(in) : law.trial(in);
    const LA::Vector  &gap    = in.gap[0];
    const unsigned int before = active_set.size();
    active_set.update(law.status(trial));
    const unsigned int all = active_set.size();
    // If the active set is too small, the bodies penetrate each other in a wide surrounding until
    // they are supported: the set of the law would then be far too large.
    const bool grows = n > 1 && n <= steps_of_growth && all > 1.3 * before && !was_idle;
    if (is_cold && (n <= 1 || grows))
      {
        // On a cold start only gaps are known: a part of the penetrating points becomes active.
        // Bodies that contact alone supports either are constrained by the points with zero gap, or
        // are moved into contact first.
        const bool falls  = n == 0 && !system.unconstrained_modes().empty();
        const bool stands = falls && zero_gaps_constrain_all_modes(gap);
        // With friction surfaces that touch everywhere start closed: a thin body that bends freely
        // in the first step would have slipped by anything.
        const bool         touches = n == 0 && !falls && all == 0 && contact.n_components() > 1;
        const unsigned int kept    = stands || touches ? active_set.activate_zero_gap(gap) :
                                     falls             ? active_set.deactivate_zero_gap(gap) :
                                                         active_set.restrict_to_deepest(gap, grows);
        step.restricted_set        = kept < all || (touches && kept > 0);
      }
    bool kept_kinds = false;
    if (contact.n_components() > 1)
      {
        // Slips are those of the last load step until the first step. What is kept against the law
        // is not a solution.
        if (n == 0 && !is_cold)
          kept_kinds = active_set.keep_kinds();
        // On a cold start points have slipped by anything before they close.
        if (is_cold && n <= steps_of_growth)
          active_set.stick_where_closing();
        active_set.stick_where_traction_turns(trial, in.traction);
        if (n > 0 && n <= patience)
          active_set.spread_slip(trial, traction);
        if (n > 0 && !globalised)
          active_set.hasten_slip(trial, traction);
        // Where too many have been let go before, a few at a time.
        if (n_holds > 0)
          active_set.slip_most_loaded(trial);
        if (hold_bodies(trial))
          step.restricted_set = true;
      }
    if (!globalised && n > 0)
      active_set.deactivate_tensile_regions(trial[0]);
    // Escalation if the set recurs, or if it has changed in many steps. First stage: linear solves
    // may have been too inaccurate to decide where there is pressure; those of thin bodies, which
    // bend before they are compressed, are so inaccurate that sets keep changing without recurring.
    // Second stage: globalisation, by changes of single points or by a line search. Each stage ends
    // after a bounded number of changes, so that Newton's method ends.
    const bool is_partial = my_reduction > fine_reduction;
    if (!globalised &&
        (active_set.is_cycling() || n_changes >= (is_partial ? patience : 2 * patience)))
      {
        if (is_partial)
          my_reduction = fine_reduction;
        else
          globalised = true;
        n_changes = 0;
        active_set.restart();
      }
    if (globalised && law.has_multiplier())
      active_set.change_only_most_violated(trial[0]);
    if (contact.n_components() > 1)
      active_set.alternate_kinds_of_chattering_points();
    // The displacement follows new values of supports and obstacles only in the first step. An
    // obstacle that retreats would lose all contact before the bodies follow: the last set is kept
    // for that step.
    step.kept_previous_set =
      kept_kinds ||
      (n == 0 && (active_set.restore_previous_if_active() ||
                  (!is_cold && active_set.replace_if_empty(law.status(in.traction)))));
    const ActiveSet::Changes changes = active_set.count_changes();
    step.active                      = active_set.size();
    step.changes                     = changes.all;
    step.contact_changes             = changes.of_contact;
    n_changes += step.changes > 0;
    // End of the penalty continuation, once at most 20 % of the active points change. A stiff
    // penalty reduces a contact area that is too large point by point, a soft one at once; the sign
    // of the gap, which decides, does not depend on the penalty.
    if (law.has_scaled_penalty() &&
        (globalised || (step.active > 0 && step.changes <= 0.2 * active_set.n_active_unilateral())))
      {
        law.scale_penalty(1);
        return true;
      }
    return step.changes > 0;
  }



  // Slipping points do not hold a body. If all points slip that have to hold one, the step would be
  // infinite, although only a part of them may slip in the end: some stick, fewer each time. After
  // `patience` such steps the friction does not suffice. Collective.
  bool
  ActiveSetStrategy::hold_bodies(const PointVectors &trial)
  {
    if (system.unconstrained_modes().empty() || n_holds >= patience)
      return false;
    system.find_unconstrained_modes(active_set.values());
    const UnconstrainedModes &modes = system.unconstrained_modes();
    if (modes.unconstrained().size() <= modes.unconstrainable().size() ||
        active_set.stick_least_loaded(trial, std::pow(0.5, n_holds)) == 0)
      return false;
    ++n_holds;
    return true;
  }



  // True if the points with zero gap constrain all modes that contact can constrain at all.
  // Collective.
  bool
  ActiveSetStrategy::zero_gaps_constrain_all_modes(const LA::Vector &gap)
  {
    ActiveSet touching(contact);
    // A single point does not support a body.
    if (touching.activate_zero_gap(gap) <= 1)
      return false;
    system.find_unconstrained_modes(touching.values());
    return system.unconstrained_modes().unconstrained().size() <=
           system.unconstrained_modes().unconstrainable().size();
  }
} // namespace Signorini
