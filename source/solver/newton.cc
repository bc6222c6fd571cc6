// SPDX-License-Identifier: Apache-2.0
#include "solver/newton.h"

#include "solver/step_control.h"
#include <signorini/base/text.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// True if the tractions of the state are not zero where gaps and stresses are: surfaces that
    /// just touch have pressure.
    bool
    has_last_pressure(const ContactLaw &law, const ContactState &state)
    {
      const PointVectors nothing = law.gap_operator().zeros();
      return law.trial({nothing, nothing, state.traction, state.internal})[0].linfty_norm() > 0;
    }

    /// True if the points of all ranks are tied, so that no status changes. Collective.
    bool
    has_fixed_status(const GapOperator &contact)
    {
      const LA::Vector &least    = contact.coefficients.least_status;
      bool              is_fixed = true;
      for (const auto i : least.locally_owned_elements())
        is_fixed = is_fixed && status_of(least(i)) == ContactStatus::stick;
      return Utilities::MPI::min(is_fixed ? 1 : 0, least.get_mpi_communicator()) == 1;
    }
  } // namespace



  Newton::Newton(const NewtonSettings &settings,
                 SolidResidual        &bodies,
                 ContactLaw           &law,
                 ContactSystem        &system,
                 LinearSolver         &linear_solver)
    : settings(settings)
    , bodies(bodies)
    , law(law)
    , contact(law.gap_operator())
    , system(system)
    , linear_solver(linear_solver)
    , convergence(bodies, law, settings.tolerance)
    , strategy(system, law, settings.reduction)
    , stopping{settings.tolerance}
    , x(system.zero())
  {}



  // The iteration of the class description. Each pass evaluates the state, assesses it, and unless
  // it ends (or starts an augmentation) advances by one step. It ends since assess() stops after a
  // maximal number of steps.
  NewtonReport
  Newton::solve(LA::Vector &u, ContactState &state, const StepVisitor &visit)
  {
    if (strategy.start(state.pressure(), state.status))
      is_same = false;
    convergence.restart();
    if (law.augments())
      law.augment(state.traction);

    NewtonReport report;
    Stage        stage;
    stage.rhs = system.zero();
    do
      {
        stage.step         = NewtonStep();
        stage.step.damping = stage.damping;
        evaluate(u, state, report, stage);
        assess(state, report, stage);
        if (!report.is_finished() && !stage.step.augmented)
          advance(u, state, report, stage);
        visit(stage.step);
        report.steps.push_back(stage.step);
      }
    while (!report.is_finished());
    return report;
  }



  // Gaps, stresses, active set, tractions and residuals at u. The residuals (4.1), (4.2) and (6.19)
  // become the right-hand side, block by block. Collective.
  void
  Newton::evaluate(const LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage)
  {
    NewtonStep &step           = stage.step;
    stage.gap                  = contact.gaps(u);
    stage.stress               = contact.stress(u, bodies.volumetric_stress());
    const bool      was_scaled = law.has_scaled_penalty();
    const LawInputs in{stage.gap, stage.stress, state.traction, state.internal};
    if (!contact.empty())
      {
        const unsigned int n        = report.steps.size();
        const bool         was_idle = n > 0 && report.steps.back().krylov_iterations == 0;
        if (strategy.update(in, state.traction, n, was_idle, step))
          is_same = false;
        state.status   = strategy.status();
        state.traction = law.traction(in, state.status);
      }
    stage.penalty_scale_changed = law.has_scaled_penalty() != was_scaled;

    // Forces, with the components of unconstrained modes projected out if they are to be
    // stabilised.
    LA::Vector &r = stage.rhs.block(0);
    r             = convergence.residual(u, in, state.status);
    PointVectors gap_residual;
    if (system.is_saddle_point() || law.augments())
      {
        gap_residual = law.residual(in, state.status);
        convergence.set_gap_forces(norm(gap_residual));
      }
    // With friction in space they also depend on directions of tractions.
    if (!is_same || law.n_components() == 3)
      system.find_unconstrained_modes(state.status, state.traction);
    if (settings.undetermined_modes == UnconstrainedModeTreatment::hold)
      report.stabilisation_force =
        system.unconstrained_modes().project_out(r, state.traction, stage.stress);
    step.residual           = r.l2_norm() / convergence.scale();
    step.residual_of_bodies = convergence.residual_of_bodies(r);
    // Volumetric stress: its residual counts together with that of the displacement.
    if (bodies.volumetric())
      {
        LA::Vector &m = stage.rhs.block(system.volumetric_block());
        m             = bodies.volumetric()->residual(u);
        if (contact.has_volumetric_stress())
          m += contact.force_on_volumetric_stress(state.traction, stage.stress);
        const double volume = m.l2_norm();
        step.residual       = std::hypot(step.residual, volume / convergence.scale());
        step.residual_of_bodies =
          std::max(step.residual_of_bodies, volume / convergence.smallest_reference_force());
      }
    if (system.is_saddle_point() || law.augments())
      {
        step.gap_residual = norm(gap_residual) / convergence.smallest_reference_force();
        for (unsigned int a = 0; a < gap_residual.size() && system.is_saddle_point(); ++a)
          stage.rhs.block(1 + a) = gap_residual[a];
      }
  }



  // Decide whether the iteration ends: converged; sufficient before a geometry update; a residual
  // that is no number; too many steps. With Uzawa's method a converged solution starts the next
  // augmentation (doc/theory, 4.11) until the gap converges. Unconstrained modes at a solution are
  // an error unless they are to be stabilised.
  void
  Newton::assess(const ContactState &state, NewtonReport &report, Stage &stage)
  {
    NewtonStep        &step = stage.step;
    const unsigned int n    = report.steps.size();
    if (convergence.is_force_converged(step, n > 0 ? report.steps.back().residual : 0.))
      {
        report.converged = convergence.is_gap_converged(step);
        if (!report.converged && law.augments() && n < settings.maximum_steps)
          {
            law.augment(state.traction);
            strategy.restart();
            step.augmented = true;
            return;
          }
      }
    const auto size = [](const NewtonStep &s) { return std::max(s.residual, s.gap_residual); };
    const bool keeps_contact = step.contact_changes == 0 && !step.kept_previous_set &&
                               !step.restricted_set && !law.has_scaled_penalty();
    // Few points that change between stick and slip are found as well on the next configuration.
    constexpr double few = 0.1;
    const bool       is_nearly_settled =
      step.changes == 0 || (n > 0 && size(step) <= few * size(report.steps.front()));
    // The caller's criterion, which asks for the pressure, is evaluated only while no point opens
    // or closes and the residual is below 1e-3.
    const auto is_sufficient = [&] {
      return stopping.is_sufficient && n > 0 && !report.converged && !law.augments() &&
             size(step) <= 1e-3 && stopping.is_sufficient();
    };
    if (!std::isfinite(step.residual + step.gap_residual))
      report.reason =
        "the residual is not a finite number: loads, supports or the mesh are invalid";
    else if (keeps_contact &&
             ((is_nearly_settled &&
               (n >= stopping.sufficient_steps || (n > 0 && size(step) <= stopping.tolerance))) ||
              is_sufficient()))
      report.converged = true;
    else if (!report.converged && n == settings.maximum_steps)
      report.reason = "Newton's method did not converge in " + std::to_string(n) +
                      " steps (Newton/Maximum steps)" + strategy.set().chattering_points() +
                      "; refine there, " +
                      (law.augments() ? "set Contact method/augmented Lagrangian/Scheme = auto, " :
                       law.has_multiplier() ? "take smaller load steps, " :
                                              "reduce the penalty, ") +
                      "or choose another method";
    if (!report.is_finished())
      return;
    // Information for messages: oscillating points and the body with the largest residual.
    if (!report.converged)
      {
        report.chattering = strategy.set().chattering();
        report.worst_body = convergence.worst_body(stage.rhs.block(0));
      }
    report.undetermined_modes = system.unconstrained_modes().unconstrained();
    if (!report.converged || report.undetermined_modes.empty() ||
        settings.undetermined_modes != UnconstrainedModeTreatment::refuse)
      return;
    report.converged               = false;
    report.has_unconstrained_modes = true;
    report.reason = "unconstrained rigid-body mode: " + join(report.undetermined_modes) +
                    ": neither supports nor contact constrain it, although it is not loaded; " +
                    NewtonSettings::stabilisation_advice();
  }



  // One Newton step: forcing term, linearisation, linear solve, step length, update; then bodies
  // without contact are moved along loaded unconstrained modes (4.20). Collective.
  void
  Newton::advance(LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage)
  {
    NewtonStep        &step = stage.step;
    const LA::Vector  &r    = stage.rhs.block(0);
    const unsigned int n    = report.steps.size();
    // Forcing term (doc/theory, 4.8): while the active set or the penalty changes, the next system
    // makes the digits of this solution beyond the first ones useless.
    const bool is_settled =
      contact.empty() || has_fixed_status(contact) ||
      (n > 0 && step.changes == 0 && !step.restricted_set && !stage.penalty_scale_changed);
    // A partial solution, after which the geometry is updated, needs only the digits that a Newton
    // step gains.
    const double reduction = stopping.is_partial() ? std::min(strategy.reduction(), step.residual) :
                             is_settled            ? 0. :
                                                     strategy.reduction();
    // If surfaces of an augmented law come into contact again, the last pressure acts at once
    // although the residual may be nearly zero: a line search would stop before that each time.
    const bool comes_back = law.augments() && step.active == 0 && has_last_pressure(law, state);
    const bool is_searched =
      bodies.is_nonlinear() && !step.restricted_set && !step.kept_previous_set && !comes_back;
    const LawInputs in{stage.gap, stage.stress, state.traction, state.internal};
    double          tolerance = 0.5 * stopping.tolerance * convergence.smallest_reference_force();
    // Where mainly points of the interface are wrong before a geometry update, the forces of the
    // bodies need not become more accurate.
    if (stopping.is_partial() && n > 0 && step.gap_residual > step.residual_of_bodies)
      tolerance = std::max(tolerance, 0.5 * step.residual * convergence.scale());
    linearise(u, in);
    solve_linear(stage.rhs, reduction, tolerance, step);
    // The volumetric stress takes the full step first, as the step length assumes.
    if (bodies.volumetric())
      bodies.volumetric()->add(1, x.block(system.volumetric_block()));
    stage.damping = bodies.largest_admissible_step(u, x.block(0));
    // Step length: at finite strain by the resistance (4.12), at small strain, if the active set
    // requires it, by the energy (4.11).
    if (is_searched)
      stage.damping = energy_descending_step({bodies, system, law, u, state, r}, x, stage.damping);
    else if (strategy.needs_globalisation() && has_energy(system))
      stage.damping *= energy_minimising_step(system, law, r, in, x.block(0));
    else if (contact.n_components() > 1 && !bodies.is_nonlinear() && n > 0 && step.changes > 0 &&
             !step.restricted_set && !step.kept_previous_set)
      stage.damping *= residual_reducing_step({bodies, system, law, u, state, r}, x);
    u.add(stage.damping, x.block(0));
    for (unsigned int a = 0; a < state.traction.size() && system.is_saddle_point(); ++a)
      state.traction[a].add(stage.damping, x.block(1 + a));
    // Reduce the step of the volumetric stress afterwards to that of the displacement.
    if (bodies.volumetric() && stage.damping != 1)
      bodies.volumetric()->add(stage.damping - 1, x.block(system.volumetric_block()));
    const auto loaded = system.unconstrained_modes().loaded(r, 1e-8 * convergence.scale());
    if (!loaded.empty() && !system.unconstrained_modes().move_into_contact(u, r))
      {
        report.has_unconstrained_modes = true;
        report.reason =
          "unconstrained rigid-body mode under load: " + join(loaded) +
          (contact.n_components() > 1 ?
             ": neither supports nor contact within the search distance constrain it: it slides or "
             "tips where friction does not hold it; if it does so, prescribe its motion" :
             ": neither supports nor contact within the search distance constrain it");
      }
    if (contact.has_condensed_constraints)
      bodies.constraints().distribute(u);
    // Nothing has changed in this step, and the residual cannot be reduced: stop with a message.
    if (n > 0 && step.changes == 0 && step.krylov_iterations == 0 &&
        step.residual == report.steps.back().residual && !step.restricted_set &&
        report.reason.empty())
      report.reason = "Newton's method stagnates above its tolerance: the linear solver cannot "
                      "reduce the residual further; set a larger Newton/Tolerance";
  }



  InternalFields
  Newton::internal(const LA::Vector &u, const ContactState &state) const
  {
    if (state.internal.empty())
      return {};
    const PointVectors gaps = contact.gaps(u), s = contact.stress(u, bodies.volumetric_stress());
    return law.internal({gaps, s, state.traction, state.internal}, state.status);
  }



  // CG with a right-hand side that excites all modes; its coefficients show the sign of the
  // curvature in the Krylov space. With a volumetric stress the method is FGMRES, and inverse
  // iteration is used instead.
  bool
  Newton::tangent_is_indefinite(const LA::Vector &u, const ContactState &state)
  {
    // A small tolerance, since each iteration examines another direction.
    constexpr double enough = 1e-8;
    try
      {
        const PointVectors gaps = contact.gaps(u),
                           s    = contact.stress(u, bodies.volumetric_stress());
        linearise(u, {gaps, s, state.traction, state.internal});
      }
    catch (const SolverFailure &)
      {
        // Cells are inverted at u: there is no tangent.
        return false;
      }
    LA::BlockVector forces = system.zero();
    for (const auto i : forces.block(0).locally_owned_elements())
      forces.block(0)(i) = std::sin(37. * i * i + 11. * i);
    forces.block(0).compress(VectorOperation::insert);
    bodies.constraints().set_zero(forces.block(0));
    if (bodies.volumetric())
      return finds_negative_curvature(forces);
    const auto sees_one = [&] {
      // The solver stops at the first direction of negative curvature. If it fails, the directions
      // so far count.
      try
        {
          linear_solver.solve(x, forces, enough, 0., NegativeCurvature::report);
        }
      catch (const SolverFailure &)
        {}
      return linear_solver.tangent_is_indefinite();
    };
    const bool did_include =
      linear_solver.include_geometric_in_interface(true); // to end in few iterations
    // A preconditioner of a former, indefinite tangent would report negative curvature everywhere:
    // if there was any, repeat with one of the present tangent.
    const bool result = sees_one() && (!linear_solver.request_rebuild() || sees_one());
    linear_solver.include_geometric_in_interface(did_include);
    return result;
  }



  bool
  Newton::finds_negative_curvature(LA::BlockVector forces)
  {
    constexpr unsigned int most = 4;
    // Low accuracy suffices: an error is reduced by the next iteration.
    constexpr double enough = 0.1;
    if (!system.is_symmetric())
      return false;
    const LA::Vector size = bodies.stiffness().diagonal();
    try
      {
        // Inverse iteration with the diagonal of K as mass: each solution is the right-hand side of
        // the next one, up to scaling. A negative x.f = x.K x proves negative curvature.
        for (unsigned int i = 0; i < most; ++i)
          {
            linear_solver.solve(x, forces, enough, 0.);
            bodies.constraints().set_zero(x.block(0));
            if (x.block(0) * forces.block(0) < 0)
              return true;
            forces.block(0) = x.block(0);
            forces.block(0).scale(size);
            forces.block(0) /= forces.block(0).l2_norm();
          }
      }
    catch (const SolverFailure &)
      // The tangent is singular to rounding.
      {}
    return false;
  }



  void
  Newton::linearise(const LA::Vector &u, const LawInputs &in)
  {
    bodies.linearise(u);
    is_same = is_same && system.uses_geometric_stiffness() && law.has_constant_derivatives();
    system.use_geometric_stiffness(true);
    if (is_same && version == bodies.stiffness().version())
      return;
    if (!is_same)
      system.linearise(in, strategy.status());
    linear_solver.update();
    is_same = true;
    version = bodies.stiffness().version();
  }



  unsigned int
  Newton::iterate(const LA::BlockVector &rhs,
                  const double           reduction,
                  const double           tolerance,
                  const double           residual)
  {
    // Far from equilibrium the geometric stiffness may make the tangent indefinite by itself: then
    // solve without it. Near a solution, an indefinite tangent is real.
    constexpr double far = 0.1;
    if (!stopping.is_partial() || residual < far)
      return linear_solver.solve(x, rhs, reduction, tolerance);
    try
      {
        return linear_solver.solve(x, rhs, reduction, tolerance, NegativeCurvature::reject);
      }
    catch (const IndefiniteSystem &)
      {
        system.use_geometric_stiffness(false);
        linear_solver.update();
        return linear_solver.solve(x, rhs, reduction, tolerance, NegativeCurvature::truncate);
      }
  }



  void
  Newton::solve_linear(const LA::BlockVector &rhs,
                       const double           reduction,
                       const double           tolerance,
                       NewtonStep            &step)
  {
    const bool iterates      = !linear_solver.has_fallen_back();
    step.krylov_iterations   = iterate(rhs, reduction, tolerance, step.residual);
    step.fell_back_to_direct = iterates && linear_solver.has_fallen_back();
    // Constrained ones are unknowns of their own to the linear solver, zero up to its tolerance.
    bodies.constraints().set_zero(x.block(0));
    // From lengths to tractions; those of open points are zero.
    for (unsigned int a = 0; a < law.n_components() && system.is_saddle_point(); ++a)
      to_traction(contact, strategy.status(), x.block(1 + a));
  }
} // namespace Signorini
