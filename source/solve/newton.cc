#include <signorini/parameters/section.h>
#include <signorini/solve/newton.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  void
  NewtonSettings::declare(Section &section)
  {
    section.add("Maximum steps", maximum_steps, "of Newton's method in one load step", positive);
    section.add("Tolerance",
                tolerance,
                "of the nonlinear residual, relative to the forces at work",
                Range{0, 1e-3, false});
    section.add(
      "Reduction",
      reduction,
      "of the residual by linear solves while the active set changes, relative to the loads (at most 1e-6 "
      "once a set has come up again); the last one goes down to the Tolerance",
      Range{0, 1, false, false});
    section.add(
      "Stabilisation",
      stabilisation,
      "of motions that contact alone stops, in units of E times size, until it does; the result does not depend on it",
      positive);
    section.add_choice(
      "Undetermined motions",
      undetermined,
      {"refuse", "hold"},
      "of bodies that neither supports nor contact hold, as the rotation of a pin: refuse them, or hold them "
      "where that takes less than 1 % of the contact force");
  }



  std::string
  NewtonSettings::how_to_hold()
  {
    return "prescribe a displacement that does, or set Newton/Undetermined motions = hold, which "
           "holds it and reports the force that this takes";
  }



  namespace
  {
    constexpr double fine_reduction = 1e-6; // by linear solves, once an active set comes up again
    constexpr unsigned int steps_of_growth = 5; // of a cold start, see ActiveSet::keep_deepest()

    void
    print_head(ConditionalOStream &out)
    {
      out << "    step   active  changes    residual         gap  damping  iterations" << std::endl;
    }

    void
    print_row(ConditionalOStream &out, const unsigned int number, const NewtonStep &step)
    {
      std::ostringstream row;
      row << std::setw(8) << number << std::setw(9) << step.active << std::setw(9) << step.changes
          << std::scientific << std::setprecision(2) << std::setw(12) << step.residual
          << std::setw(12) << step.gap_residual << std::fixed << std::setw(9) << step.damping
          << std::setw(12) << step.krylov_iterations;
      out << row.str() << std::endl;
    }
  } // namespace



  Newton::Newton(const NewtonSettings                   &settings,
                 const LinearSolverSettings             &linear_settings,
                 const ContactMethod                    &method,
                 const LA::SparseMatrix                 &stiffness,
                 const AffineConstraints<double>        &constraints,
                 const GapOperator                      &contact,
                 const std::vector<std::vector<double>> &modes,
                 const std::vector<unsigned int>        &bodies,
                 const unsigned int                      dim,
                 TimerOutput                            &timer,
                 FreeMotions                             free_motions)
    : settings(settings)
    , K(stiffness)
    , constraints(constraints)
    , contact(contact)
    , law(method, contact)
    , system(stiffness, law, std::move(free_motions))
    , linear_solver(linear_settings, system, modes, dim, timer)
    , bodies(bodies)
    , active_set(contact)
  {
    const auto last = std::max_element(bodies.begin(), bodies.end());
    n_bodies =
      Utilities::MPI::max(last == bodies.end() ? 0u : *last + 1, stiffness.get_mpi_communicator());
    stiffness_diagonal = system.zero().block(0);
    for (const auto i : stiffness_diagonal.locally_owned_elements())
      stiffness_diagonal(i) = K.diag_element(i);
    stiffness_diagonal.compress(VectorOperation::insert);
  }



  LA::Vector
  Newton::residual(const LA::Vector &f,
                   const LA::Vector &u,
                   const LA::Vector &p,
                   const LA::Vector &stress)
  {
    LA::Vector r;
    r.reinit(f);
    system.internal_force(r, u);
    r.sadd(-1, 1, f);
    double scale = f.l2_norm();
    at_work.assign(n_bodies, scale);
    if (!contact.empty())
      {
        const LA::Vector force = contact.force(p, stress);
        r += force;
        scale   = std::max(scale, force.l2_norm());
        at_work = forces_at_work(force, scale);
      }
    constraints.set_zero(r);
    force_scale = scale;
    // The forces of a cold start may be far larger, as penalties of bodies that overlap; their
    // rounding is all that they leave behind.
    largest_force = std::max(largest_force, scale);
    // What that leaves is an answer only if it is little.
    force_rounding = std::max(1e-15 * largest_force, std::min(rounding(u), 1e-4 * scale));
    return r;
  }



  std::vector<double>
  Newton::norms_of_bodies(const LA::Vector &force) const
  {
    std::vector<double> squares(n_bodies, 0.);
    auto                body = bodies.begin();
    for (const double x : force)
      squares[*body++] += x * x;
    Utilities::MPI::sum(squares, force.get_mpi_communicator(), squares);
    for (double &x : squares)
      x = std::sqrt(x);
    return squares;
  }



  std::vector<double>
  Newton::forces_at_work(const LA::Vector &contact_force, const double scale) const
  {
    // Below the last, rounding of the largest forces would be all that is asked for.
    constexpr double    most = 1e3, least = 1e-4;
    std::vector<double> forces = norms_of_bodies(contact_force);
    for (double &force : forces)
      force = force > 0 ? std::clamp(most * force, least * scale, scale) : scale;
    return forces;
  }



  double
  Newton::residual_of_bodies(const LA::Vector &r) const
  {
    const std::vector<double> norms   = norms_of_bodies(r);
    double                    largest = 0;
    for (unsigned int body = 0; body < n_bodies; ++body)
      if (at_work[body] > 0)
        largest = std::max(largest, norms[body] / at_work[body]);
    return largest;
  }



  double
  Newton::rounding(const LA::Vector &u) const
  {
    // The terms of K u cancel where bodies move far and are strained little, as in bending.
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    LA::Vector       terms   = stiffness_diagonal;
    terms.scale(u);
    constraints.set_zero(terms);
    const double of_bodies = 2 * epsilon * terms.l2_norm();
    if (contact.empty() || law.is_mixed())
      return of_bodies;
    LA::Vector springs = contact.zero();
    for (const auto i : springs.locally_owned_elements())
      springs(i) = contact.weight(i) * law.response(i, {}, active_set.values()(i) > 0).dp_dg;
    springs.compress(VectorOperation::insert);
    const double length = 2 * u.linfty_norm() + contact.initial_gap.linfty_norm();
    return of_bodies + epsilon * length * springs.l2_norm();
  }



  NewtonReport
  Newton::solve(
    const LA::Vector &f, LA::Vector &u, LA::Vector &p, LA::Vector &active, ConditionalOStream &out)
  {
    if (active_set.set(active))
      factorised = false;
    active_set.restart();
    cautious      = false;
    reduction     = settings.reduction;
    largest_force = 0;
    is_cold       = has_no_pressure(p);
    law.soften(is_cold ? law.softest() : 1);
    if (law.augments())
      law.augment(p);

    NewtonReport report;
    const auto   record = [&](const NewtonStep &step) {
      print_row(out, report.steps.size(), step);
      report.steps.push_back(step);
    };
    LA::BlockVector x = system.zero(), rhs = system.zero();
    LA::Vector      gap, stress;
    double          damping = 1;
    print_head(out);
    for (unsigned int n = 0;; ++n)
      {
        NewtonStep step;
        step.damping        = damping;
        gap                 = contact.gap(u);
        stress              = contact.stress(u);
        const bool was_soft = law.is_soft();
        if (!contact.empty())
          {
            const bool was_idle = n > 0 && report.steps.back().krylov_iterations == 0;
            update_active_set({gap, stress, p}, n, was_idle, step);
            active = active_set.values();
            p      = law.pressure({gap, stress, p}, active);
          }

        LA::Vector r = residual(f, u, p, stress);
        if (!factorised)
          system.find_loose_motions(active_set.values());
        if (settings.undetermined == "hold")
          report.holding_force = system.free_motions().hold(r, p, stress);
        rhs.block(0)            = r;
        const double scale      = force_scale > 0 ? force_scale : 1.;
        step.residual           = r.l2_norm() / scale;
        step.residual_of_bodies = residual_of_bodies(r);
        const double least =
          force_scale > 0 ? *std::min_element(at_work.begin(), at_work.end()) : 1.;
        if (system.is_saddle_point() || law.augments())
          {
            const LA::Vector defect = law.defect({gap, stress, p}, active_set.values());
            step.gap_residual       = defect.l2_norm() / least;
            if (system.is_saddle_point())
              rhs.block(1) = defect;
          }
        const double before = n > 0 ? report.steps.back().residual : 0;

        if (is_balanced(step, before, scale))
          {
            report.converged = is_closed(step, least);
            if (!report.converged && law.augments() && n < settings.maximum_steps)
              {
                augment(p);
                step.augments = true;
                record(step);
                continue;
              }
          }
        if (!std::isfinite(step.residual + step.gap_residual))
          report.reason = "the residual is not a number: loads, supports or the mesh are invalid";
        else if (!report.converged && n == settings.maximum_steps)
          report.reason = "Newton's method did not converge in " + std::to_string(n) +
                          " steps (Newton/Maximum steps)" + active_set.chattering_points();
        if (report.converged || !report.reason.empty())
          {
            record(step);
            report.undetermined = system.free_motions().loose();
            if (report.converged && !report.undetermined.empty() &&
                settings.undetermined == "refuse")
              {
                report.converged = false;
                report.is_loose  = true;
                report.reason    = "nothing determines " + join(report.undetermined) +
                                ": no force drives it, but neither supports nor contact hold it; " +
                                NewtonSettings::how_to_hold();
              }
            return report;
          }

        // As long as the active set or the penalty changes, the next one throws away what goes
        // beyond a good guess.
        const bool is_settled = contact.empty() || (n > 0 && step.changes == 0 && !step.withholds &&
                                                    law.is_soft() == was_soft);
        step.krylov_iterations =
          solve_linear(x, rhs, is_settled ? 0. : reduction, 0.5 * settings.tolerance * least, out);
        damping = cautious && has_energy() ? line_search(r, {gap, stress, p}, x.block(0)) : 1.;
        u.add(damping, x.block(0));
        if (system.is_saddle_point())
          p += x.block(1);
        const auto driven = system.free_motions().driven(r, 1e-8 * scale);
        if (!driven.empty() && !system.free_motions().close(u, r))
          {
            report.is_loose = true;
            report.reason   = "nothing stops " + join(driven) +
                            ": no support, and no contact within reach in that direction";
          }
        if (contact.tied)
          constraints.distribute(u);
        record(step);
        if (!report.reason.empty())
          return report;
        if (n > 0 && step.krylov_iterations == 0 && step.residual == before && !step.withholds)
          {
            report.reason =
              "Newton's method stagnates above its tolerance: the linear solver cannot "
              "reduce the residual further; loosen Newton/Tolerance";
            return report;
          }
      }
  }



  bool
  Newton::has_energy() const
  {
    return !contact.empty() && !system.is_saddle_point() && system.is_symmetric();
  }



  void
  Newton::augment(const LA::Vector &p)
  {
    law.augment(p);
    cautious = false;
    active_set.restart();
  }



  bool
  Newton::is_balanced(const NewtonStep &step, const double before, const double scale) const
  {
    // Points that hardly touch may change between any two steps, to no effect.
    constexpr double largest_undecided = 1e-8;
    const bool       at_bottom = step.changes == 0 && before > 0 && step.residual > before / 2 &&
                           step.residual <= force_rounding / scale;
    const double of_all = std::max(step.residual, step.residual_of_bodies);
    // Nothing is left of forces that were there before but their rounding.
    const bool is_over =
      scale <= 10 * force_rounding && step.residual * scale <= 10 * force_rounding;
    const bool is_small =
      of_all <= settings.tolerance && (step.changes == 0 || step.residual <= largest_undecided);
    return (is_small || at_bottom || is_over) && !step.follows && !step.withholds &&
           (!law.is_soft() || step.active == 0);
  }



  bool
  Newton::is_closed(const NewtonStep &step, const double scale) const
  {
    // What an augmentation changes is known up to the residual that the last solution left.
    return step.gap_residual <=
           (law.augments() ? 10 : 1) * std::max(settings.tolerance, force_rounding / scale);
  }



  unsigned int
  Newton::solve_linear(LA::BlockVector       &x,
                       const LA::BlockVector &rhs,
                       const double           reduction,
                       const double           tolerance,
                       ConditionalOStream    &out)
  {
    if (!factorised)
      {
        system.set_active(active_set.values());
        linear_solver.update();
        factorised = true;
      }
    const bool         iterates   = !linear_solver.has_given_up();
    const unsigned int iterations = linear_solver.solve(x, rhs, reduction, tolerance);
    if (iterates && linear_solver.has_given_up())
      out << "    the iterative solver does not converge: the system is factorised from here on"
          << std::endl;
    // Constrained ones are unknowns of their own to the linear solver, zero up to its tolerance.
    constraints.set_zero(x.block(0));
    if (system.is_saddle_point())
      {
        x.block(1).scale(contact.stiffness);
        x.block(1).scale(active_set.values());
      }
    return iterations;
  }



  bool
  Newton::has_no_pressure(const LA::Vector &p) const
  {
    double largest = 0;
    for (const auto i : p.locally_owned_elements())
      if (contact.permanent(i) == 0)
        largest = std::max(largest, std::abs(p(i)));
    return Utilities::MPI::max(largest, K.get_mpi_communicator()) == 0;
  }



  void
  Newton::update_active_set(const LawInputs   &in,
                            const unsigned int n,
                            const bool         was_idle,
                            NewtonStep        &step)
  {
    const LA::Vector   trial  = law.trial(in);
    const unsigned int before = active_set.size();
    active_set.update(law.pushes(trial));
    const unsigned int all = active_set.size();
    // From a zone that is too small bodies overlap far around it, until they rest on it.
    const bool grows = n > 1 && n <= steps_of_growth && all > 1.3 * before && !was_idle;
    if (is_cold && (n <= 1 || grows))
      {
        const bool         falls  = n == 0 && !system.free_motions().empty();
        const bool         stands = falls && touches_where_it_can(in.gap);
        const unsigned int kept   = stands ? active_set.add_touching(in.gap) :
                                    falls  ? active_set.drop_touching(in.gap) :
                                             active_set.keep_deepest(in.gap, grows);
        step.withholds            = kept < all;
      }
    if (!cautious && n > 0)
      active_set.open_pulling_regions(trial);
    if (!cautious && active_set.seen_before())
      {
        // The linear solves may have been too rough to tell where there is pressure.
        if (reduction > fine_reduction)
          reduction = fine_reduction;
        else
          cautious = true;
        active_set.restart();
      }
    if (cautious && law.is_mixed())
      active_set.keep_all_but_the_worst(trial);
    // An obstacle that retreats has lost all contact before the bodies follow: let them first.
    step.follows = n == 0 && active_set.keep_last_if_any();
    step.active  = active_set.size();
    step.changes = active_set.count_changes();
    // A stiff penalty peels a contact zone that is too large point by point, a soft one at once.
    // The sign of the gap, which decides, knows nothing of the penalty.
    if (law.is_soft() &&
        (cautious || (step.active > 0 && step.changes <= 0.2 * active_set.size_of_separating())))
      {
        law.soften(1);
        factorised = false;
      }
    if (step.changes > 0)
      factorised = false;
  }



  bool
  Newton::touches_where_it_can(const LA::Vector &gap)
  {
    ActiveSet touching(contact);
    // On a tip nothing stands.
    if (touching.add_touching(gap) <= 1)
      return false;
    system.find_loose_motions(touching.values());
    return system.free_motions().loose().size() <= system.free_motions().never_held().size();
  }



  double
  Newton::line_search(const LA::Vector &r, const LawInputs &in, const LA::Vector &du) const
  {
    // The energy along u + a du is convex; its derivative is minus the residual there:
    //   phi'(a) = -r.du + a du.K du - [B du].W (p(a) - p(0)) - [S du].W/eps (a S du - p(a) + p(0)),
    // the last term with Nitsche's method (theta = 1) only, and p(a) from the law.
    LA::Vector K_du, B_du = contact.zero();
    K_du.reinit(du);
    system.internal_force(K_du, du);
    contact.B_free.vmult(B_du, du);
    LA::Vector S_du = contact.zero();
    if (contact.has_stress())
      contact.S_free.vmult(S_du, du);
    const double   slope = -(r * du), curvature = K_du * du;
    const double   theta      = contact.theta;
    const MPI_Comm comm       = du.get_mpi_communicator();
    const auto     derivative = [&](const double a) {
      double sum = 0;
      for (const auto i : B_du.locally_owned_elements())
        {
          LawInput there = in(i);
          there.gap += a * B_du(i);
          there.stress += a * S_du(i);
          const bool   pushes = law.pushes(i, law.trial(i, there));
          const double dp     = law.response(i, there, pushes).pressure - in.pressure(i);
          sum += contact.weight(i) *
                 (dp * B_du(i) + theta / contact.epsilon(i) * S_du(i) * (a * S_du(i) - dp));
        }
      return slope + a * curvature - Utilities::MPI::sum(sum, comm);
    };
    if (std::abs(derivative(1)) <= 0.1 * std::abs(slope))
      return 1;
    double low = 0, high = 1;
    while (derivative(high) < 0 && high < 1e3)
      {
        low = high;
        high *= 2;
      }
    for (unsigned int i = 0; i < 60 && high - low > 1e-10 * high; ++i)
      {
        const double middle                   = (low + high) / 2;
        (derivative(middle) < 0 ? low : high) = middle;
      }
    return (low + high) / 2;
  }
} // namespace Signorini
