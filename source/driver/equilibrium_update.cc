// SPDX-License-Identifier: Apache-2.0
// Updates of the contact geometry: whether they are needed, and the sequence of them.
#include "driver/equilibrium.h"
#include <signorini/base/text.h>
#include <signorini/contact/methods/method.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  StoppingCriteria
  Equilibrium<dim>::first_stopping_criteria(const double tolerance, const bool is_predicted) const
  {
    // Each update of the configuration changes the solution, so that a solution before the last
    // update needs only a few digits.
    const double enough =
      is_predicted                                                                   ? 1e-1 :
      elasticity.is_finite_strain()                                                  ? 1e-2 :
      my_uses_current_geometry || scene.contact.geometry == ContactGeometry::updated ? 1e-3 :
                                                                                       0;
    return {std::max(tolerance, enough)};
  }



  // Criteria between two updates: one Newton step each. With Uzawa's augmentation, which takes
  // several steps, the number of steps is not limited, and the tolerance follows the last residual
  // at finite strain.
  template <int dim>
  StoppingCriteria
  Equilibrium<dim>::next_stopping_criteria(const double tolerance, const double before) const
  {
    // Uzawa's method: a relative tolerance instead of one step.
    if (scene.contact.chosen().pressure_shift() == PressureShift::last_pressure)
      return {elasticity.is_finite_strain() ?
                std::max(tolerance, before > 0 ? 5e-3 * before : 1e-4) :
                tolerance};
    return {tolerance, 1};
  }



  // Decide between reference and current contact geometry (doc/theory, 5.7). With `automatic`, the
  // neglected pressure change is estimated from the present iterate or solution; once an update is
  // needed, the current geometry is used from then on.
  template <int dim>
  bool
  Equilibrium<dim>::needs_geometry_update(const bool is_solution)
  {
    const ContactGeometry wanted = scene.contact.geometry;
    if (my_uses_current_geometry)
      return true;
    // Ties that begin late have the points of the undeformed bodies.
    if (wanted == ContactGeometry::automatic && scene.contact.chosen().has_late_ties)
      return false;
    if (wanted == ContactGeometry::automatic)
      {
        TimerOutput::Scope scope(timer, "contact geometry");
        // Obstacles given by a formula of the gap on the undeformed surface admit the reference
        // geometry only.
        if (const std::string unknown = contact.obstacle_without_projection(); !unknown.empty())
          {
            if (is_solution)
              out << "  contact geometry: reference, because the Gap of '" << unknown
                  << "' is defined on the undeformed surface only" << std::endl;
          }
        else
          {
            LA::Vector u = state.displacement;
            elasticity.distribute(u);
            const double change =
              contact.neglected(u, configuration_solver.contact_state().pressure()).pressure;
            my_uses_current_geometry = change > decisions.geometry_tolerance();
            if (!my_uses_current_geometry && !is_solution)
              return false;
            my_neglected = change;
            if (constexpr double none = 1e-8; my_uses_current_geometry || change > none)
              out << "  contact geometry: updating it changes the pressure by about "
                  << short_text(100 * change, 2) << " %"
                  << (my_uses_current_geometry ? ": the contact geometry is updated from here on" :
                                                 "")
                  << std::endl;
          }
      }
    else
      my_uses_current_geometry = wanted == ContactGeometry::updated;
    return my_uses_current_geometry;
  }



  // Geometry update until convergence (doc/theory, 5.2): place the surfaces at the last
  // displacement, search, assemble the linearised gap and the contact geometric stiffness, and take
  // one Newton step. Since all terms are consistently linearised, the sequence is Newton's method
  // for the full problem. It ends when the first residual after an update satisfies (5.3), or at
  // small strain when (5.4) predicts that the next one would; then a last solution to the full
  // tolerance follows on that configuration. It fails after `most` updates, or `patience` without a
  // smaller residual, so that it terminates.
  template <int dim>
  bool
  Equilibrium<dim>::update_geometry_until_converged(const double t,
                                                    const double tolerance,
                                                    const bool   is_placed)
  {
    const bool             is_finite_strain = elasticity.is_finite_strain();
    const unsigned int     most             = is_finite_strain ? 40 : 20;
    const double           enough           = std::max(tolerance, scene.newton.of_geometry);
    constexpr unsigned int patience = 8, most_rules = 5;
    // First residual of the previous update.
    double before = 0;
    // Smallest first residual so far.
    double least = std::numeric_limits<double>::max();
    // Number of updates since then.
    unsigned int in_vain = 0;
    for (unsigned int n = 1; n <= most && in_vain < patience; ++n)
      {
        bool keeps_integration_points = false;
        if (n > 1 || !is_placed)
          {
            // At small strain, the integration points are kept after a few updates. At finite
            // strain the result must not depend on the path to it: they are kept only if the
            // iteration does not converge otherwise, because points may alternate between faces at
            // kinks and edges.
            keeps_integration_points =
              n > 1 && (is_finite_strain ?
                          in_vain > patience / 2 :
                          n > most_rules || contact.is_geometry_current(state.displacement));
            configuration_solver.set_configuration(state.displacement);
            configuration_solver.find_contact(true, keeps_integration_points);
            previous_steps = my_report.steps;
          }
        if (!solve_fixed_configuration(t, next_stopping_criteria(tolerance, before), true))
          return false;
        // The first step of an update has the residual with the new surfaces and the old
        // displacement.
        const NewtonStep &first = my_report.steps[previous_steps.size()];
        const double      now   = std::max(first.residual_of_bodies, first.gap_residual);
        // Predict the residual of the next update, which may then be saved. It decreases faster
        // than at the rate of the last two updates, since the iteration converges quadratically;
        // with fixed integration points an order of 1.5 is assumed. Reported contact forces then
        // have the normals of this configuration, accurate to its residual. No prediction at finite
        // strain, where edges of two bodies may slide past each other, which no tangent contains.
        const double rate = before > 0 ? now / before : 1;
        const bool   is_foreseen =
          !is_finite_strain && rate <= 0.1 && now <= 1000 * enough &&
          (now * rate <= 0.1 * enough || (keeps_integration_points && now <= 100 * enough &&
                                          now * std::pow(rate, 1.5) <= 0.1 * enough));
        if (now <= enough || is_foreseen)
          {
            const NewtonStep &last = my_report.steps.back();
            if (!is_finite_strain &&
                std::max({last.residual, last.residual_of_bodies, last.gap_residual}) <= tolerance)
              return true;
            if (!is_finite_strain)
              previous_steps = my_report.steps;
            return solve_fixed_configuration(t, {tolerance}, true);
          }
        before  = now;
        in_vain = now < least ? 0 : in_vain + 1;
        least   = std::min(least, now);
      }
    // Advice for the message: rounding far from the origin, shorter load steps, or smoother
    // integration.
    const bool by_segments =
      std::all_of(decisions.pairs.begin(), decisions.pairs.end(), [&](auto &pair) {
        return decisions.integration_of(pair).rule == Rule::segments;
      });
    const auto &[low, high] = elasticity.mesh().extent().get_boundary_points();
    // Distance from the origin in sizes of the model.
    constexpr double far    = 1e3;
    const bool       is_far = (low + (high - low) / 2).norm() > far * low.distance(high);
    my_report.converged     = false;
    my_report.reason =
      "the contact geometry update did not converge: " +
      std::string(
        is_far ?
          "the model lies so far from the origin that gaps are inaccurate by round-off: shift it to "
          "the origin, or set a larger Newton/Geometry tolerance, which is now " +
            short_text(scene.newton.of_geometry) + " of the forces; or " :
          "") +
      "use smaller load steps (Load steps/Number)" +
      (!is_finite_strain ? ", or set Contact method/Contact geometry = reference" :
       !by_segments      ? ", or set Contact method/Integration = segments" :
                           "");
    return false;
  }



#define INSTANTIATE(dim)                                                                           \
  template StoppingCriteria Equilibrium<dim>::first_stopping_criteria(double, bool) const;         \
  template StoppingCriteria Equilibrium<dim>::next_stopping_criteria(double, double) const;        \
  template bool             Equilibrium<dim>::needs_geometry_update(bool);                         \
  template bool             Equilibrium<dim>::update_geometry_until_converged(double, double, bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Signorini
