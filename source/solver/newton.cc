#include "solver/newton.h"

#include "solver/line_search.h"
#include "solver/step_length.h"
#include <signorini/base/text.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Surfaces that just touch press on each other.
    bool
    has_last_pressure(const ContactLaw &law, const ContactState &state)
    {
      const PointVectors nothing = law.gap_operator().zeros();
      return law.trial({nothing, nothing, state.traction, state.internal})[0].linfty_norm() > 0;
    }

    /// The norm of all components.
    double
    norm(const PointVectors &vectors)
    {
      if (vectors.size() == 1)
        return vectors[0].l2_norm();
      double square = 0;
      for (const LA::Vector &component : vectors)
        square += component.norm_sqr();
      return std::sqrt(square);
    }
  } // namespace



  Newton::Newton(const NewtonSettings &settings,
                 Bodies               &bodies,
                 ContactLaw           &law,
                 ContactSystem        &system,
                 LinearSolver         &linear_solver)
    : settings(settings)
    , bodies(bodies)
    , law(law)
    , contact(law.gap_operator())
    , system(system)
    , linear_solver(linear_solver)
    , balance(bodies, law, settings.tolerance)
    , strategy(system, law, settings.reduction)
    , goal{settings.tolerance}
    , x(system.zero())
  {}



  NewtonReport
  Newton::solve(LA::Vector &u, ContactState &state, const StepVisitor &visit)
  {
    if (strategy.start(state.pressure(), state.status))
      is_same = false;
    balance.restart();
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
        judge(state, report, stage);
        if (!report.is_over() && !stage.step.augments)
          advance(u, state, report, stage);
        visit(stage.step);
        report.steps.push_back(stage.step);
      }
    while (!report.is_over());
    return report;
  }



  void
  Newton::evaluate(const LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage)
  {
    NewtonStep &step         = stage.step;
    stage.gap                = contact.gaps(u);
    stage.stress             = {contact.stress(u, bodies.bulk_stress())};
    const bool      was_soft = law.is_soft();
    const LawInputs in{stage.gap, stage.stress, state.traction, state.internal};
    if (!contact.empty())
      {
        const unsigned int n        = report.steps.size();
        const bool         was_idle = n > 0 && report.steps.back().krylov_iterations == 0;
        if (strategy.update(in, n, was_idle, step))
          is_same = false;
        state.status   = strategy.status();
        state.traction = law.traction(in, state.status);
      }
    stage.softness_changed = law.is_soft() != was_soft;

    LA::Vector &r = stage.rhs.block(0);
    r             = balance.residual(u, in, state.status);
    PointVectors gap_residual;
    if (system.is_saddle_point() || law.augments())
      {
        gap_residual = law.residual(in, state.status);
        balance.set_forces_of_gaps(norm(gap_residual));
      }
    if (!is_same)
      system.find_loose_motions(state.status);
    if (settings.undetermined == Undetermined::hold)
      report.holding_force = system.free_motions().hold(r, state.traction, stage.stress[0]);
    step.residual           = r.l2_norm() / balance.scale();
    step.residual_of_bodies = balance.residual_of_bodies(r);
    if (bodies.bulk())
      {
        LA::Vector &m = stage.rhs.block(system.bulk_block());
        m             = bodies.bulk()->residual(u);
        if (contact.has_bulk_stress())
          m += contact.force_on_bulk(state.traction, stage.stress[0]);
        const double volume     = m.l2_norm();
        step.residual           = std::hypot(step.residual, volume / balance.scale());
        step.residual_of_bodies = std::max(step.residual_of_bodies, volume / balance.least());
      }
    if (system.is_saddle_point() || law.augments())
      {
        step.gap_residual = norm(gap_residual) / balance.least();
        for (unsigned int a = 0; a < gap_residual.size() && system.is_saddle_point(); ++a)
          stage.rhs.block(1 + a) = gap_residual[a];
      }
  }



  void
  Newton::judge(const ContactState &state, NewtonReport &report, Stage &stage)
  {
    NewtonStep        &step = stage.step;
    const unsigned int n    = report.steps.size();
    if (balance.is_balanced(step, n > 0 ? report.steps.back().residual : 0.))
      {
        report.converged = balance.is_closed(step);
        if (!report.converged && law.augments() && n < settings.maximum_steps)
          {
            law.augment(state.traction);
            strategy.restart();
            step.augments = true;
            return;
          }
      }
    const bool stays     = step.changes == 0 && !step.follows && !step.withholds && !law.is_soft();
    const auto is_enough = [&] {
      return goal.is_enough && n > 0 && !report.converged && !law.augments() &&
             std::max(step.residual, step.gap_residual) <= 1e-3 && goal.is_enough();
    };
    if (!std::isfinite(step.residual + step.gap_residual))
      report.reason =
        "the residual is not a finite number: loads, supports or the mesh are invalid";
    else if (stays && (n >= goal.enough_steps || is_enough()))
      report.converged = true;
    else if (!report.converged && n == settings.maximum_steps)
      report.reason = "Newton's method did not converge in " + std::to_string(n) +
                      " steps (Newton/Maximum steps)" + strategy.set().chattering_points();
    if (!report.is_over())
      return;
    if (!report.converged)
      {
        report.chattering = strategy.set().chattering();
        report.worst_body = balance.worst_body(stage.rhs.block(0));
      }
    report.undetermined = system.free_motions().loose();
    if (!report.converged || report.undetermined.empty() ||
        settings.undetermined != Undetermined::refuse)
      return;
    report.converged = false;
    report.is_loose  = true;
    report.reason    = "unconstrained rigid-body mode: " + join(report.undetermined) +
                    ": neither supports nor contact constrain it, although it is not loaded; " +
                    NewtonSettings::how_to_hold();
  }



  void
  Newton::advance(LA::Vector &u, ContactState &state, NewtonReport &report, Stage &stage)
  {
    NewtonStep        &step = stage.step;
    const LA::Vector  &r    = stage.rhs.block(0);
    const unsigned int n    = report.steps.size();
    // As long as the active set or the penalty changes, the next one throws away what goes beyond a
    // good guess.
    const bool is_settled =
      contact.empty() || (n > 0 && step.changes == 0 && !step.withholds && !stage.softness_changed);
    // As many digits as a step of Newton's method finds where surfaces move on.
    const double reduction = goal.is_rough() ? std::min(strategy.reduction(), step.residual) :
                             is_settled      ? 0. :
                                               strategy.reduction();
    // Surfaces that come back to where they touch have the last pressure there at once, though next
    // to none may be left in balance: a search would stop before that, again and again.
    const bool comes_back = law.augments() && step.active == 0 && has_last_pressure(law, state);
    const bool is_searched =
      bodies.is_nonlinear() && !step.withholds && !step.follows && !comes_back;
    const LawInputs in{stage.gap, stage.stress, state.traction, state.internal};
    linearise(u, in);
    solve_linear(stage.rhs, reduction, 0.5 * goal.tolerance * balance.least(), step);
    if (bodies.bulk())
      bodies.bulk()->add(1, x.block(system.bulk_block()));
    stage.damping = bodies.longest_step(u, x.block(0));
    if (is_searched)
      stage.damping = descending_step({bodies, system, law, u, state, r}, x, stage.damping);
    else if (strategy.is_cautious() && has_energy(system))
      stage.damping *= best_step(system, law, r, in, x.block(0));
    u.add(stage.damping, x.block(0));
    for (unsigned int a = 0; a < state.traction.size() && system.is_saddle_point(); ++a)
      state.traction[a].add(stage.damping, x.block(1 + a));
    if (bodies.bulk() && stage.damping != 1)
      bodies.bulk()->add(stage.damping - 1, x.block(system.bulk_block()));
    const auto driven = system.free_motions().driven(r, 1e-8 * balance.scale());
    if (!driven.empty() && !system.free_motions().close(u, r))
      {
        report.is_loose = true;
        report.reason   = "unconstrained rigid-body mode under load: " + join(driven) +
                        ": neither supports nor contact within the search distance constrain it";
      }
    if (contact.tied)
      bodies.constraints().distribute(u);
    if (n > 0 && step.changes == 0 && step.krylov_iterations == 0 &&
        step.residual == report.steps.back().residual && !step.withholds && report.reason.empty())
      report.reason = "Newton's method stagnates above its tolerance: the linear solver cannot "
                      "reduce the residual further; set a larger Newton/Tolerance";
  }



  InternalFields
  Newton::internal(const LA::Vector &u, const ContactState &state) const
  {
    if (state.internal.empty())
      return {};
    const PointVectors gaps = contact.gaps(u), s = {contact.stress(u, bodies.bulk_stress())};
    return law.internal({gaps, s, state.traction, state.internal}, state.status);
  }



  bool
  Newton::curves_down(const LA::Vector &u, const ContactState &state)
  {
    constexpr double enough = 1e-8; // each iteration sees more
    try
      {
        const PointVectors gaps = contact.gaps(u), s = {contact.stress(u, bodies.bulk_stress())};
        linearise(u, {gaps, s, state.traction, state.internal});
      }
    catch (const SolverFailure &)
      {
        return false; // cells are folded there
      }
    LA::BlockVector forces = system.zero();
    for (const auto i : forces.block(0).locally_owned_elements())
      forces.block(0)(i) = std::sin(37. * i * i + 11. * i);
    forces.block(0).compress(VectorOperation::insert);
    bodies.constraints().set_zero(forces.block(0));
    if (bodies.bulk())
      return takes_work_back(forces);
    const auto sees_one = [&] {
      try
        {
          linear_solver.solve(
            x, forces, enough, 0., NegativeCurvature::is_told); // no farther than the first one
        }
      catch (const SolverFailure &)
        {} // what it has seen counts
      return linear_solver.curves_down();
    };
    const bool did_turn = linear_solver.let_zones_turn(true); // to end in few iterations
    // A preconditioner that is left from where the tangent curved down sees that everywhere.
    const bool result = sees_one() && (!linear_solver.renew() || sees_one());
    linear_solver.let_zones_turn(did_turn);
    return result;
  }



  bool
  Newton::takes_work_back(LA::BlockVector forces)
  {
    constexpr unsigned int most   = 4;
    constexpr double       enough = 0.1; // each turn makes up for what the one before has left
    if (!bodies.is_symmetric())
      return false;
    const LA::Vector size = bodies.stiffness().diagonal();
    try
      {
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
      {} // as good as singular
    return false;
  }



  void
  Newton::linearise(const LA::Vector &u, const LawInputs &in)
  {
    bodies.linearise(u);
    is_same = is_same && system.turns_forces() && law.has_constant_derivatives();
    system.turn_forces(true);
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
    // Far from balance, forces of contact may seem to turn so fast that nothing resists; near a
    // solution that is so, it is.
    constexpr double far = 0.1;
    if (!goal.is_rough() || residual < far)
      return linear_solver.solve(x, rhs, reduction, tolerance);
    try
      {
        return linear_solver.solve(x, rhs, reduction, tolerance, NegativeCurvature::refuses);
      }
    catch (const IndefiniteSystem &)
      {
        system.turn_forces(false);
        linear_solver.update();
        return linear_solver.solve(x, rhs, reduction, tolerance, NegativeCurvature::stops);
      }
  }



  void
  Newton::solve_linear(const LA::BlockVector &rhs,
                       const double           reduction,
                       const double           tolerance,
                       NewtonStep            &step)
  {
    const bool iterates    = !linear_solver.has_given_up();
    step.krylov_iterations = iterate(rhs, reduction, tolerance, step.residual);
    step.gives_up          = iterates && linear_solver.has_given_up();
    // Constrained ones are unknowns of their own to the linear solver, zero up to its tolerance.
    bodies.constraints().set_zero(x.block(0));
    // From lengths to tractions; those of open points are zero.
    for (unsigned int a = 0; a < law.n_components() && system.is_saddle_point(); ++a)
      to_traction(contact, strategy.status(), x.block(1 + a));
  }
} // namespace Signorini
