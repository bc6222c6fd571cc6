// An active set that goes round in a circle, if it may.

#include <signorini/solve/newton.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <doctest/doctest.h>

#include <array>
#include <sstream>

#include "two_blocks.h"

using namespace TestScene;

namespace
{
  /// minimise u.K u/2 - f.u with u <= 0. From u = 0 the sets {}, {0, 2}, {0, 1} follow each other
  /// for ever (Curtis, Han, Robinson, Comput. Optim. Appl. 60 (2015) 311-341); the solution has the
  /// set {0}.
  struct Circle
  {
    static constexpr double K[3][3] = {{4, 5, -5}, {5, 9, -5}, {-5, -5, 7}};
    static constexpr double f[3]    = {2, 1, -3};

    explicit Circle(const ContactMethod &method)
      : owned(
          LA::contiguous_partition(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 ? 3 : 0,
                                   MPI_COMM_WORLD))
      , load(owned, MPI_COMM_WORLD)
    {
      constraints.close();
      contact.dofs = owned;
      contact.pair.assign(owned.n_elements(), 0);
      DynamicSparsityPattern full(3, 3);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          full.add(i, j);
      stiffness.reinit(owned, full, MPI_COMM_WORLD);
      contact.B.reinit(owned, full, MPI_COMM_WORLD);
      for (LA::Vector *v : {&contact.weight, &contact.stiffness, &contact.epsilon})
        v->reinit(owned, MPI_COMM_WORLD);
      contact.weight    = 1.;
      contact.stiffness = 1.;
      contact.epsilon   = method.penalty({1, 1, 1});
      for (const auto i : owned)
        {
          for (unsigned int j = 0; j < 3; ++j)
            stiffness.set(i, j, K[i][j]);
          contact.B.set(i, i, -1);
          load(i) = f[i];
        }
      for (auto *matrix : {&stiffness, &contact.B})
        matrix->compress(VectorOperation::insert);
      load.compress(VectorOperation::insert);
      contact.B_free.copy_from(contact.B);
      contact.initial_gap = contact.rest_gap = contact.permanent = contact.zero();
    }

    IndexSet                  owned;
    LA::Vector                load;
    LA::SparseMatrix          stiffness;
    AffineConstraints<double> constraints;
    GapOperator               contact;
  };

  void
  check(const std::string                                      &name,
        const std::vector<std::pair<std::string, std::string>> &settings,
        const double                                            penetration)
  {
    CAPTURE(name);
    const auto           method = make_method(name, settings);
    const Circle         circle(*method);
    LinearSolverSettings solver;
    solver.preconditioner = "direct";
    std::ostringstream log;
    ConditionalOStream out(log, true);
    TimerOutput        timer(out, TimerOutput::never, TimerOutput::wall_times);
    Newton             newton({},
                  solver,
                  *method,
                  circle.stiffness,
                  circle.constraints,
                  circle.contact,
                  {},
                  {0, 0, 0},
                  1,
                  timer);
    LA::Vector         u = circle.load, p = circle.contact.zero();
    u                         = 0.;
    p                         = 1e-3; // not a cold start, which would choose a better first set
    LA::Vector         active = circle.contact.zero();
    const NewtonReport report = newton.solve(circle.load, u, p, active, print_steps(out));
    CAPTURE(log.str());
    CHECK(report.converged);
    CHECK(report.steps.size() > 3);
    const std::array<double, 3> solution = {{0, -4. / 19, -11. / 19}};
    for (const auto i : circle.owned)
      CHECK(u(i) == doctest::Approx(solution[i]).epsilon(penetration));
  }
} // namespace

TEST_CASE("a cycle of the active set is left")
{
  check("Lagrange multiplier", {}, 1e-9);
  check("penalty", {{"Factor", "1e6"}}, 1e-4);
}
