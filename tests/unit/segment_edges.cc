// SPDX-License-Identifier: Apache-2.0
// What Newton's method does not know: which bodies, and which law.

#include "solid/rigid_body_modes.h"
#include "solver/contact_solver.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "contact_cases.h"
#include "dense_problem.h"
#include "small_scene.h"
#include <Eigen/Dense>

using namespace TestScene;

namespace
{
  /// F(u) = K u + c u^3, component by component.
  class StiffeningSolid : public SolidResidual
  {
  public:
    StiffeningSolid(const Elasticity<2> &elasticity, const double c)
      : elasticity(elasticity)
      , c(c)
      , f(elasticity.load())
      , body(bodies_of_dofs(elasticity))
      , K(matrix)
    {
      matrix.copy_from(elasticity.stiffness());
    }

    void
    set_load(LA::Vector load) override
    {
      f = std::move(load);
    }

    LA::Vector
    forces(const LA::Vector &u) const
    {
      LA::Vector force = f;
      elasticity.stiffness().vmult(force, u);
      for (const auto i : f.locally_owned_elements())
        force(i) = force(i) + c * u(i) * u(i) * u(i);
      force.compress(VectorOperation::insert);
      return force;
    }

    LA::Vector
    residual(const LA::Vector &u) const override
    {
      LA::Vector r = f;
      r -= forces(u);
      return r;
    }

    double
    load_size() const override
    {
      return f.l2_norm();
    }

    void
    linearise(const LA::Vector &u) override
    {
      ++n_linearisations;
      matrix.copy_from(elasticity.stiffness());
      for (const auto i : f.locally_owned_elements())
        if (!elasticity.constraints().is_constrained(i))
          matrix.add(i, i, 3 * c * u(i) * u(i));
      matrix.compress(VectorOperation::add);
      K.has_changed();
    }

    const Stiffness &
    stiffness() const override
    {
      return K;
    }

    const AffineConstraints<double> &
    constraints() const override
    {
      return elasticity.constraints();
    }

    const std::vector<unsigned int> &
    body_of_dof() const override
    {
      return body;
    }

    unsigned int n_linearisations = 0;

  private:
    const Elasticity<2>            &elasticity;
    const double                    c;
    LA::Vector                      f;
    const std::vector<unsigned int> body;
    LA::SparseMatrix                matrix;
    AssembledStiffness              K;
  };

  /// Springs against gap and slip, which know of each other.
  class Glue : public ContactLaw
  {
  public:
    Glue(const GapOperator &contact, const Eigen::Matrix2d &springs)
      : ContactLaw(contact)
      , springs(springs)
    {}

    bool
    has_multiplier() const override
    {
      return false;
    }

    bool
    is_symmetric() const override
    {
      return springs(0, 1) == springs(1, 0);
    }

    using ContactLaw::status;
    using ContactLaw::trial;

    LawVector
    trial(const Index, const LawInput &in) const override
    {
      LawVector result;
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int b = 0; b < 2; ++b)
          result[a] -= springs(a, b) * in.gap[b];
      return result;
    }

    ContactStatus
    status(const Index, const LawVector &) const override
    {
      return ContactStatus::stick;
    }

    LawResponse
    response(const Index i, const LawInput &in, const ContactStatus status) const override
    {
      LawResponse result;
      if (status == ContactStatus::open)
        return result;
      result.traction = trial(i, in);
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int b = 0; b < 2; ++b)
          result.by_gap[a][b] = -springs(a, b);
      return result;
    }

  private:
    const Eigen::Matrix2d springs;
  };
} // namespace



TEST_CASE("bodies that stiffen: of second order, with contact, whatever solves the linear systems")
{
  for (const std::string method : {"penalty", "Lagrange multiplier", "Nitsche"})
    for (const std::string preconditioner : {"interface multigrid", "direct"})
      {
        CAPTURE(method);
        CAPTURE(preconditioner);
        SmallScene<2> scene(cases_2d().front().lines + Lines{"Dimension=2", "Mesh/Degree=1"});
        scene.use({"Method=" + method});
        const Elasticity<2> &elasticity = *scene.elasticity;
        LA::Vector           u, p;
        REQUIRE(scene.solve(1, u, p).converged);
        // Of the size of the linear forces, at the displacement of the linear solution.
        const double c =
          elasticity.stiffness().linfty_norm() / (u.linfty_norm() * u.linfty_norm()) / 10;

        StiffeningSolid      bodies(elasticity, c);
        LinearSolverSettings settings = scene.scene.solver;
        settings.preconditioner       = preconditioner;
        Silence            silence;
        SolidHierarchy     hierarchies(settings, bodies.stiffness(), elasticity);
        ContactSolver      solver(scene.scene.newton,
                             settings,
                             scene.method(),
                             bodies,
                             scene.gap_operator(),
                             scene.unconstrained_modes(),
                             hierarchies,
                             silence.timer);
        const LA::Vector   linear = u;
        ContactState       state  = open_contact(scene.gap_operator());
        const NewtonReport report = solver.newton.solve(u, state, print_steps(silence.out));
        CAPTURE(silence.log.str());
        CHECK(report.converged);
        elasticity.distribute(u);

        // Another answer than that of linear bodies, in balance.
        LA::Vector change = u;
        change -= linear;
        CHECK(change.l2_norm() > 0.01 * linear.l2_norm());
        LA::Vector r = elasticity.load();
        r -= bodies.forces(u);
        r += scene.gap_operator().force(state.traction, scene.gap_operator().stress(u));
        elasticity.constraints().set_zero(r);
        CHECK(r.l2_norm() < 1e-8 * elasticity.load().l2_norm());

        // Each step with a stiffness of its own.
        const auto &steps = report.steps;
        CHECK(bodies.n_linearisations + 1 == steps.size());
        bool is_quadratic = false;
        for (unsigned int n = 0; n + 1 < steps.size(); ++n)
          if (steps[n + 1].changes == 0 && steps[n].residual < 1e-2 && steps[n].residual > 1e-6)
            {
              is_quadratic = true;
              CHECK(steps[n + 1].residual < std::max(1e-9, 100 * std::pow(steps[n].residual, 2)));
            }
        CHECK(is_quadratic);
      }
}



TEST_CASE("linear bodies: one hierarchy, whatever is asked of it")
{
  SmallScene<2>      scene(cases_2d().front().lines + Lines{"Dimension=2", "Mesh/Degree=1"});
  LinearElasticSolid bodies(std::make_unique<AssembledStiffness>(scene.elasticity->stiffness()),
                            scene.elasticity->stabilising_stiffness(),
                            scene.elasticity->constraints(),
                            bodies_of_dofs(*scene.elasticity));
  SolidHierarchy     hierarchies(scene.scene.solver, bodies.stiffness(), *scene.elasticity);
  const auto         first = hierarchies.get();
  REQUIRE(first);
  bodies.linearise(scene.elasticity->zero_vector());
  CHECK(hierarchies.get() == first);
}



TEST_CASE("a law with two components a point is another law, not another solver")
{
  const unsigned int n = 6; // three points
  Eigen::MatrixXd    K = 4 * Eigen::MatrixXd::Identity(n, n), B(n, n);
  Eigen::VectorXd    f(n), g_0(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      f[i]   = std::sin(1. + i);
      g_0[i] = 0.1 * std::cos(2. * i);
      for (unsigned int j = 0; j < n; ++j)
        {
          K(i, j) += 1. / (1 + i + j);
          B(i, j) = std::sin(0.3 + 1.7 * i + 0.9 * j * j);
        }
    }
  for (const double lower : {1., -1.}) // also without symmetry
    for (const std::string preconditioner : {"interface multigrid", "direct"})
      {
        CAPTURE(lower);
        CAPTURE(preconditioner);
        Eigen::Matrix2d springs;
        springs << 3, 1, lower, 2;
        Eigen::MatrixXd D = Eigen::MatrixXd::Zero(n, n);
        for (unsigned int i = 0; i < n; i += 2)
          D.block<2, 2>(i, i) = springs;
        const Eigen::VectorXd expected =
          (K + B.transpose() * D * B).partialPivLu().solve(f - B.transpose() * D * g_0);

        const DenseProblem   problem(K, f, B, g_0, 1, 2);
        LinearSolverSettings settings;
        settings.preconditioner = preconditioner;
        Silence            silence;
        LinearElasticSolid bodies = problem.bodies();
        Glue               law(problem.contact, springs);
        ContactSystem      system(bodies.stiffness(), law);
        SolidHierarchy     hierarchies(bodies.stiffness(), 1, [&] {
          const std::vector<double> ones(problem.owned.n_elements(), 1.);
          return std::make_shared<const Hierarchy>(bodies.stiffness(),
                                                   std::vector<Level>(),
                                                   std::vector(1, ones),
                                                   1);
        });
        LinearSolver       linear_solver(settings, system, hierarchies, silence.timer);
        Newton             newton({}, bodies, law, system, linear_solver);
        LA::Vector         u      = problem.load;
        ContactState       state  = open_contact(problem.contact);
        u                         = 0.;
        const NewtonReport report = newton.solve(u, state, print_steps(silence.out));
        CAPTURE(silence.log.str());
        CHECK(report.converged);
        CHECK(report.steps.size() <= 4);
        for (const auto i : problem.owned)
          CHECK(u(i) == doctest::Approx(expected[i]).epsilon(1e-9));
      }
}
