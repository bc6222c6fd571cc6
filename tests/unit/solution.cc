// SPDX-License-Identifier: Apache-2.0
// Solutions of all methods, judged by the weak forms once more from their definitions; and what
// must not change them: the form of the linear system, and units.

#include "contact/laws/normal_contact.h"
#include "solver/preconditioners/factorised.h"

#include <doctest/doctest.h>

#include <cmath>

#include "contact_cases.h"
#include "reference.h"

using namespace TestScene;

namespace
{
  template <int dim>
  double
  work_on_rigid_bodies(const Elasticity<dim> &elasticity, const Values &w, const double t)
  {
    double sum = 0;
    for (unsigned int b = 0; b < elasticity.rigid_bodies().size(); ++b)
      for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
        sum += elasticity.rigid_bodies()[b].load(i, t, elasticity.rotation_length_scale()) *
               w[elasticity.first_dof(b) + i];
    return sum;
  }

  /// What the program promises: the norm of the residual, and that of the gaps times E/h, are below
  /// the tolerance times that of the forces at work.
  template <int dim>
  void
  check_solution(SmallScene<dim> &scene)
  {
    LA::Vector         u, p;
    const NewtonReport report = scene.solve(1, u, p);
    REQUIRE(report.converged);
    const ReferenceContact<dim> reference(scene);
    const Values all_u = everywhere(u), all_p = everywhere(p), gap = reference.gap(all_u),
                 stress    = reference.stress(all_u);
    const LA::Vector w     = scene.rough_field(1, 1.9);
    const Values     all_w = distributed_change(*scene.elasticity, w);
    const LA::Vector force = scene.gap_operator().force({p}, scene.gap_operator().stress(u));
    const double     scale = std::max(force.l2_norm(), scene.elasticity->load().l2_norm());
    CHECK(force.l2_norm() > 0);

    const double residual = reference_work(scene, all_u, all_w, 1) +
                            reference.work(all_p, stress, all_w) -
                            work_on_rigid_bodies(*scene.elasticity, all_w, 1);
    CHECK(std::abs(residual) < 2 * scene.scene.newton.tolerance * scale * w.l2_norm());

    unsigned int n_active  = 0;
    const bool   bilateral = !scene.decisions.pairs[0].can_separate;
    for (unsigned int i = 0; i < all_p.size(); ++i)
      {
        const double predicted =
          scene.method().pressure_shift() == PressureShift::none          ? 0 :
          scene.method().pressure_shift() == PressureShift::normal_stress ? stress[i] :
                                                                            all_p[i];
        const double law        = predicted - reference.epsilon[i] * gap[i];
        const double error      = all_p[i] - (bilateral ? law : std::max(0., law));
        const double as_a_force = std::abs(error) * reference.area[i] *
                                  std::min(1., reference.stiffness[i] / reference.epsilon[i]);
        CHECK(as_a_force < 20 * scene.scene.newton.tolerance * scale);
        n_active += all_p[i] != 0;
      }
    CHECK(n_active > 0);
  }

  template <int dim>
  void
  check_solutions(const Case &which, const std::string &degree, const std::vector<Lines> &methods)
  {
    CAPTURE(which.name);
    CAPTURE(degree);
    SmallScene<dim> scene(which.lines +
                          Lines{"Dimension=" + std::to_string(dim), "Mesh/Degree=" + degree});
    for (const Lines &method : methods)
      {
        const std::string how = join(method);
        CAPTURE(how);
        scene.use(method);
        check_solution(scene);
      }
  }
} // namespace



TEST_CASE("solutions fulfil the law of contact and balance all forces")
{
  for (const Case &which : cases_2d())
    check_solutions<2>(which, which.name[0] == 'c' ? "2" : "1", all_methods());
  for (const Case &which : cases_3d())
    check_solutions<3>(which, "1", {{"Method=Lagrange multiplier"}, {"Method=Nitsche"}});
}



namespace
{
  /// The step that Newton's method takes from there.
  template <int dim>
  LA::Vector
  direction(const SmallScene<dim> &scene,
            const LA::Vector      &u,
            const LA::Vector      &p,
            const LA::Vector      &active)
  {
    const GapOperator       &contact = scene.gap_operator();
    const NormalContact      law(scene.method(), contact);
    const AssembledStiffness K(scene.elasticity->stiffness());
    ContactSystem            system(K, law);
    system.set_status(active);
    LA::BlockVector  right = system.zero(), x = system.zero();
    const LA::Vector gap = contact.gap(u), none = contact.zero(),
                     pressure = law.traction({{gap}, {none}, {p}, {}}, active)[0];
    scene.elasticity->stiffness().vmult(right.block(0), u);
    right.block(0).sadd(-1, 1, scene.elasticity->load());
    right.block(0) += contact.force({pressure}, contact.zeros());
    scene.elasticity->constraints().set_zero(right.block(0));
    if (system.is_saddle_point())
      right.block(1) = law.residual({{gap}, {none}, {pressure}, {}}, active)[0];
    right.compress(VectorOperation::insert);
    Direct solver(system,
                  Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1 ? LA::DirectLibrary::KLU :
                                                                         LA::DirectLibrary::MUMPS);
    solver.update();
    solver.vmult(x, right);
    scene.elasticity->constraints().set_zero(x.block(0));
    return x.block(0);
  }

  template <int dim>
  void
  check_forms(const Case &which, const std::string &degree)
  {
    CAPTURE(which.name);
    CAPTURE(degree);
    SmallScene<dim> scene(which.lines +
                          Lines{"Dimension=" + std::to_string(dim), "Mesh/Degree=" + degree});
    if (scene.elasticity->has_unsupported_modes())
      return;
    scene.elasticity->set_time(1);
    LA::Vector u = scene.rough_field(0.004, 0.3);
    scene.elasticity->distribute(u);
    std::vector<LA::Vector> results;
    for (const std::string form : {"block", "condensed"})
      {
        scene.use({"Method=perturbed Lagrangian",
                   "perturbed Lagrangian/Factor=7",
                   "perturbed Lagrangian/System=" + form});
        const NormalContact law(scene.method(), scene.gap_operator());
        const LA::Vector    gap = scene.gap_operator().gap(u), none = scene.gap_operator().zero(),
                         active = law.status(law.trial({{gap}, {none}, {none}, {}})),
                         p      = active; // any pressure: the system is linear in it
        results.push_back(direction(scene, u, p, active));
      }
    const double size = results[0].l2_norm();
    CHECK(size > 0);
    results[0] -= results[1];
    CHECK(results[0].l2_norm() < 1e-10 * size);
  }
} // namespace

TEST_CASE("the condensed form and the saddle point have the same solution")
{
  for (const std::string degree : {"1", "2"})
    for (const Case &which : cases_2d())
      check_forms<2>(which, degree);
  for (const Case &which : cases_3d())
    check_forms<3>(which, "1");
}



namespace
{
  /// A ball under a force and moments on a block with hanging nodes, in units of length and stress.
  Lines
  ball_on_block(const double length, const double stress)
  {
    std::ostringstream L, S;
    L.precision(17);
    S.precision(17);
    L << length;
    S << stress;
    return {"Dimension=3",
            "Definitions/L=" + L.str(),
            "Definitions/S=" + S.str(),
            "Bodies/Names=block, base",
            "Bodies/base/Corners=-L,-L,-1.5*L : L,L,-L",
            "Bodies/base/Subdivisions=3,2,1",
            "Bodies/base/Young's modulus=20*S",
            "Bodies/base/Poisson's ratio=0.2",
            "Bodies/block/Corners=-L,-L,-L : L,L,0",
            "Bodies/block/Subdivisions=2,2,1",
            "Bodies/block/Young's modulus=10*S",
            "Bodies/block/Poisson's ratio=0.3",
            "Obstacles/Names=ball",
            "Obstacles/ball/Shape=sphere",
            "Obstacles/ball/Center=0.1*L,0,3*L",
            "Obstacles/ball/Radius=3*L",
            "Obstacles/ball/Reference point=0.1*L,0,0",
            "Obstacles/ball/Displacement=0; 0; free",
            "Obstacles/ball/Rotation=free; 0; 0",
            "Obstacles/ball/Force=0; 0; -0.1*S*L^2*t",
            "Obstacles/ball/Moment=0.001*S*L^3*t; 0; 0",
            "Supports/Names=bottom, side",
            "Supports/side/Boundaries=block.left",
            "Supports/side/Displacement=0; 0; free",
            "Supports/bottom/Boundaries=base.bottom",
            "Supports/bottom/Displacement=0.001*x; 0; 0.001*L",
            "Loads/Names=side, weight",
            "Loads/side/Boundaries=block.right",
            "Loads/side/Pressure=0.01*S*(1+z/L)",
            "Loads/weight/Bodies=block",
            "Loads/weight/Body force=0; 0; -0.01*S/L",
            "Contact pairs/Names=top, joint",
            "Contact pairs/top/Slave=block.top",
            "Contact pairs/top/Master=ball",
            "Contact pairs/joint/Slave=block.bottom",
            "Contact pairs/joint/Master=base.top",
            "Contact pairs/joint/Initial gap=0.001*L*cos(3*x/L)",
            "Mesh/Refinement regions/Names=near",
            "Mesh/Refinement regions/near/Inside=min(0.1*L - x, 0.1*L + z)",
            "Newton/Unconstrained modes=stabilise"};
  }
} // namespace

TEST_CASE("units do not matter in space")
{
  // Powers of two: rounding is the same too.
  const double  L = std::pow(2, -10), S = std::pow(2, 20);
  SmallScene<3> scene(ball_on_block(1, 1)), scaled(ball_on_block(L, S));
  for (const Lines &method : {Lines{"Method=Lagrange multiplier"},
                              Lines{"Method=penalty"},
                              Lines{"Method=augmented Lagrangian"},
                              Lines{"Method=Nitsche"}})
    {
      CAPTURE(method[0]);
      LA::Vector u, p, u_scaled, p_scaled;
      scene.use(method);
      scaled.use(method);
      const NewtonReport report = scene.solve(1, u, p), other = scaled.solve(1, u_scaled, p_scaled);
      CHECK(report.converged);
      CHECK(other.converged);
      REQUIRE(report.steps.size() == other.steps.size());
      for (unsigned int i = 0; i < report.steps.size(); ++i)
        {
          CHECK(report.steps[i].active == other.steps[i].active);
          CHECK(report.steps[i].krylov_iterations == other.steps[i].krylov_iterations);
        }
      u_scaled.add(-L, u);
      CHECK(u_scaled.linfty_norm() < 1e-8 * L * u.linfty_norm());
      p_scaled.add(-S, p);
      CHECK(p_scaled.linfty_norm() < 1e-8 * S * p.linfty_norm());
    }
}
