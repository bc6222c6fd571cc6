// SPDX-License-Identifier: Apache-2.0
// Several solutions at one load, and how the tangent tells.

#include "solver/contact_solver.h"

#include <doctest/doctest.h>

#include "dense_problem.h"
#include "two_blocks.h"

using namespace TestScene;

namespace
{
  /// The displacements of the point, and the friction over the critical one.
  struct Result
  {
    double u_n = 0, u_t = 0, friction_over_critical = 0;
  };

  constexpr double w = 1.5, f_n = -10, f_t = -9;

  /// A point on springs whose normal and tangential displacements are coupled by w, against a wall
  /// with friction (Klarbring, Ingenieur-Archiv 60 (1990) 529-541):
  ///
  ///     3 u_n + w u_t = f_n + p,   w u_n + u_t = f_t + t.
  ///
  /// Where it slips towards negative u_t, t = mu p and (1 - mu w) u_t = f_t - mu f_n: beyond mu =
  /// 1/w the tangent changes its sign, and the loads of this test have three solutions. It may slip
  /// with u_t = 2 (f_n - f_t), stick, or open.
  ///
  /// @return the solution that Newton's method finds from a state.
  Result
  solve(const std::string           &name,
        const double                 friction,
        const Eigen::Vector2d       &force,
        const std::array<double, 2> &start,
        const std::array<double, 2> &traction,
        const ContactStatus          status)
  {
    const auto method =
      name == "penalty" ? make_method(name, {{"Factor", "1e7"}}) : make_method(name);
    method->has_friction = true;
    Eigen::Matrix2d K;
    K << 3, w, w, 1;
    DenseProblem problem(K,
                         force,
                         Eigen::Matrix2d::Identity(),
                         Eigen::Vector2d::Zero(),
                         method->penalty({1, 1, 1}),
                         2);
    problem.contact.coefficients.friction = friction;
    LinearSolverSettings direct;
    direct.preconditioner = "direct";
    Silence            silence;
    LinearElasticSolid bodies = problem.bodies();
    SolidHierarchy     hierarchies(bodies.stiffness(), 1);
    ContactSolver      solver(
      {}, direct, *method, bodies, problem.contact, {}, hierarchies, silence.timer);
    LA::Vector   u     = problem.load;
    ContactState state = open_contact(problem.contact);
    state.internal     = solver.law->initial_fields();
    for (const auto i : problem.owned)
      u(i) = start[i];
    for (const auto i : state.status.locally_owned_elements())
      {
        state.status(i) = static_cast<double>(status);
        for (unsigned int a = 0; a < 2; ++a)
          state.traction[a](i) = traction[a];
      }
    const NewtonReport report = solver.newton.solve(u, state, print_steps(silence.out));
    INFO(silence.log.str());
    CHECK(report.converged);
    Result result;
    result.friction_over_critical = solver.newton.friction_over_critical(u, state);
    for (const auto i : problem.owned)
      (i == 0 ? result.u_n : result.u_t) = u(i);
    result.u_n = Utilities::MPI::sum(result.u_n, MPI_COMM_WORLD);
    result.u_t = Utilities::MPI::sum(result.u_t, MPI_COMM_WORLD);
    return result;
  }
} // namespace

TEST_CASE("beyond the critical friction a point slips, sticks or opens at the same load")
{
  for (const std::string name : {"Lagrange multiplier", "augmented Lagrangian", "penalty"})
    {
      CAPTURE(name);
      const double accuracy = name == "penalty" ? 1e-5 : 1e-9;
      // With these loads p = w u_t - f_n = 7 where it slips.
      const Result slips = solve(name, 1, {f_n, f_t}, {{0, -2}}, {{7, 7}}, ContactStatus::slip);
      CHECK(slips.u_t == doctest::Approx(-2).epsilon(accuracy));
      CHECK(slips.friction_over_critical == doctest::Approx(w).epsilon(accuracy));
      const Result sticks = solve(name, 1, {f_n, f_t}, {{0, 0}}, {{10, 9}}, ContactStatus::stick);
      CHECK(std::abs(sticks.u_t) < accuracy);
      CHECK(sticks.friction_over_critical == 0);
      const Result opens = solve(name, 1, {f_n, f_t}, {{4.7, -16}}, {{0, 0}}, ContactStatus::open);
      CHECK(opens.u_n == doctest::Approx(14. / 3).epsilon(accuracy));
      CHECK(opens.friction_over_critical == 0);
    }
}

TEST_CASE(
  "below the critical friction, and along the other direction, the solution is the only one")
{
  for (const std::string name : {"Lagrange multiplier", "augmented Lagrangian", "penalty"})
    {
      CAPTURE(name);
      const double accuracy = name == "penalty" ? 1e-5 : 1e-9;
      const Result below    = solve(name, 0.5, {-10, -6}, {{0, 0}}, {{0, 0}}, ContactStatus::open);
      CHECK(below.u_t == doctest::Approx(-4).epsilon(accuracy));
      CHECK(below.friction_over_critical == doctest::Approx(0.5 * w).epsilon(accuracy));
      const Result other = solve(name, 1, {-10, 20}, {{0, 0}}, {{0, 0}}, ContactStatus::open);
      CHECK(other.u_t == doctest::Approx(10 / (1 + w)).epsilon(accuracy));
      CHECK(other.friction_over_critical == 0);
    }
}
