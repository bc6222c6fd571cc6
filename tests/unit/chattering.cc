// SPDX-License-Identifier: Apache-2.0
// An active set that goes round in a circle, if it may.

#include "solver/contact_solver.h"

#include <doctest/doctest.h>

#include <array>

#include "dense_problem.h"
#include "two_blocks.h"

using namespace TestScene;

namespace
{
  /// minimise u.K u/2 - f.u with u <= 0. From u = 0 the sets {}, {0, 2}, {0, 1} follow each other
  /// for ever (Curtis, Han, Robinson, Comput. Optim. Appl. 60 (2015) 311-341); the solution has the
  /// set {0}.
  DenseProblem
  circle(const ContactMethod &method)
  {
    Eigen::Matrix3d K;
    K << 4, 5, -5, 5, 9, -5, -5, -5, 7;
    return {K,
            Eigen::Vector3d(2, 1, -3),
            -Eigen::Matrix3d::Identity(),
            Eigen::Vector3d::Zero(),
            method.penalty({1, 1, 1})};
  }

  void
  check(const std::string                                      &name,
        const std::vector<std::pair<std::string, std::string>> &settings,
        const double                                            penetration)
  {
    CAPTURE(name);
    const auto           method  = make_method(name, settings);
    const DenseProblem   problem = circle(*method);
    LinearSolverSettings direct;
    direct.preconditioner = "direct";
    Silence            silence;
    LinearElasticSolid bodies = problem.bodies();
    SolidHierarchy     hierarchies(bodies.stiffness(), 1);
    ContactSolver      solver(
      {}, direct, *method, bodies, problem.contact, {}, hierarchies, silence.timer);
    LA::Vector   u            = problem.load;
    ContactState state        = open_contact(problem.contact);
    u                         = 0.;
    state.traction[0]         = 1e-3; // not a cold start, which would choose a better first set
    const NewtonReport report = solver.newton.solve(u, state, print_steps(silence.out));
    CAPTURE(silence.log.str());
    CHECK(report.converged);
    CHECK(report.steps.size() > 3);
    const std::array<double, 3> solution = {{0, -4. / 19, -11. / 19}};
    for (const auto i : problem.owned)
      CHECK(u(i) == doctest::Approx(solution[i]).epsilon(penetration));
  }
} // namespace

TEST_CASE("a cycle of the active set is left")
{
  check("Lagrange multiplier", {}, 1e-9);
  check("penalty", {{"Factor", "1e6"}}, 1e-4);
}
