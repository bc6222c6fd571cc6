// The linearised systems against finite differences of the nonlinear residual.

#include <signorini/contact/normal_stress.h>
#include <signorini/elasticity/kernel.h>
#include <signorini/solve/contact_system.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <doctest/doctest.h>

#include <cmath>

#include "two_blocks.h"

using namespace Signorini;
using namespace dealii;
using namespace TestScene;

namespace
{
  /// K u minus the contact forces, and the active set at u.
  template <int dim>
  LA::Vector
  internal_force(const TwoBlocks<dim> &scene,
                 const ContactMethod  &method,
                 const LA::Vector     &u,
                 LA::Vector           &active)
  {
    LA::Vector       p = scene.contact->zero();
    const LA::Vector s = scene.contact->stress(u); // zero for the penalty, as its predictor
    const LA::Vector g = scene.contact->gap(u);
    find_active(*scene.contact, g, s, active);
    set_pressure(method, *scene.contact, g, s, active, p);
    LA::Vector r = scene.elasticity.zero_vector();
    scene.elasticity.stiffness().vmult(r, u);
    r -= scene.contact->force(p, s);
    scene.elasticity.constraints().set_zero(r);
    return r;
  }

  template <int dim>
  void
  check_tangent(const ContactMethod &method, const unsigned int degree)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    const TwoBlocks<dim> scene(method, degree);
    const LA::Vector     u = scene.field(2e-3, 1.7), du = scene.field(1, 0.9);

    LA::Vector active = scene.contact->zero(), active_plus = active, active_minus = active;
    internal_force(scene, method, u, active);
    const double n_active = active.l1_norm();
    CHECK(n_active > 0);
    CHECK(n_active < active.size());

    // Central difference; the law is piecewise linear, so it is exact as long as no point switches.
    const double h    = 1e-8;
    LA::Vector   plus = u, minus = u;
    plus.add(h, du);
    minus.add(-h, du);
    LA::Vector difference = internal_force(scene, method, plus, active_plus);
    difference -= internal_force(scene, method, minus, active_minus);
    difference /= 2 * h;
    active_plus -= active;
    active_minus -= active;
    REQUIRE(active_plus.l1_norm() + active_minus.l1_norm() == 0);

    ContactSystem system(scene.elasticity.stiffness(), *scene.contact, method);
    system.set_active(active);
    LA::BlockVector src = system.zero(), dst = system.zero();
    src.block(0) = du;
    system.vmult(dst, src);
    LA::Vector tangent = dst.block(0);
    scene.elasticity.constraints().set_zero(tangent);
    tangent -= difference;
    CHECK(tangent.l2_norm() < 1e-5 * difference.l2_norm());
  }

  template <int dim>
  void
  check_saddle_point(const unsigned int degree)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    const auto           method = make_method("Lagrange multiplier");
    const TwoBlocks<dim> scene(*method, degree);
    ContactSystem        system(scene.elasticity.stiffness(), *scene.contact, *method);
    LA::Vector           active = scene.contact->zero();
    for (const auto i : active.locally_owned_elements())
      active(i) = i % 2;
    active.compress(VectorOperation::insert);
    system.set_active(active);

    // Symmetric: x.Ay = y.Ax.
    LA::BlockVector x = system.zero(), y = system.zero(), Ax = system.zero(), Ay = system.zero();
    x.block(0) = scene.field(1, 0.3);
    y.block(0) = scene.field(1, 1.1);
    for (const auto i : active.locally_owned_elements())
      {
        x.block(1)(i) = std::cos(0.7 * i);
        y.block(1)(i) = std::sin(2. + i);
      }
    x.compress(VectorOperation::insert);
    y.compress(VectorOperation::insert);
    system.vmult(Ax, x);
    system.vmult(Ay, y);
    CHECK(x * Ay == doctest::Approx(y * Ax));

    // The second row is the change of the gap, in forces; the first the change of the residual.
    LA::Vector gap = scene.contact->gap(x.block(0));
    gap -= scene.contact->gap(scene.elasticity.zero_vector());
    LA::Vector pressure = scene.contact->zero();
    for (const auto i : active.locally_owned_elements())
      {
        const double scale = scene.contact->weight(i) * scene.contact->stiffness(i);
        const double row   = active(i) > 0 ? -scale * gap(i) : -scale * x.block(1)(i);
        CHECK(Ax.block(1)(i) == doctest::Approx(row));
        pressure(i) = active(i) * scene.contact->stiffness(i) * x.block(1)(i);
      }
    pressure.compress(VectorOperation::insert);
    LA::Vector force = scene.elasticity.zero_vector();
    scene.elasticity.stiffness().vmult(force, x.block(0));
    force -= scene.contact->force(pressure, scene.contact->zero());
    force -= Ax.block(0);
    CHECK(force.l2_norm() < 1e-12 * Ax.block(0).l2_norm());
  }
} // namespace



TEST_CASE("tangent of the penalty method against finite differences")
{
  for (const char *weighting : {"mortar", "pointwise"})
    for (const unsigned int degree : {1, 2})
      {
        CAPTURE(weighting);
        const auto method = make_method("penalty", {{"Factor", "5"}, {"Weighting", weighting}});
        check_tangent<2>(*method, degree);
        check_tangent<3>(*method, degree);
      }
}



TEST_CASE("tangent of Nitsche's method against finite differences")
{
  for (const char *theta : {"1", "0", "-1"})
    for (const char *unbiased : {"no", "yes"})
      for (const unsigned int degree : {1, 2})
        {
          CAPTURE(theta);
          CAPTURE(unbiased);
          const auto method = make_method("Nitsche", {{"Theta", theta}, {"Unbiased", unbiased}});
          check_tangent<2>(*method, degree);
          check_tangent<3>(*method, degree);
        }
}



namespace
{
  template <int dim>
  void
  check_bound(const unsigned int degree)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    const TwoBlocks<dim> scene(*make_method("Nitsche"), degree);
    auto                 cell = scene.elasticity.dof_handler().begin_active();
    while (cell != scene.elasticity.dof_handler().end() && !cell->is_locally_owned())
      ++cell;
    if (cell == scene.elasticity.dof_handler().end())
      return;
    const unsigned int                   face = 1;
    const Tensor<1, dim>                 n    = Point<dim>::unit_vector(0);
    NormalStress<dim>                    stress(scene.elasticity);
    std::vector<types::global_dof_index> indices(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(indices);
    stress.reinit(cell);
    const double bound = stress.bound(face);

    StiffnessKernel<dim> kernel(scene.mesh,
                                scene.elasticity.finite_elements(),
                                scene.elasticity.model());
    FullMatrix<double>   K;
    kernel.assemble(cell, scene.elasticity.material(cell->material_id()), K);
    const QGauss<dim - 1> rule(degree + 2);
    FullMatrix<double>    M(K.m()); // int (n . sigma n)^2 dA
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const SparseRow row = stress.row(unit_point<dim>(face, rule.point(q)), n, n);
        Vector<double>  s(K.m());
        for (const auto &[index, value] : row)
          s[std::find(indices.begin(), indices.end(), index) - indices.begin()] = value;
        FullMatrix<double> outer(K.m());
        outer.outer_product(s, s);
        M.add(rule.weight(q) * cell->face(face)->measure(), outer);
      }

    // The quotient of any displacement is below the bound; power iteration with K + M, whose
    // quotient grows with the other, comes close to it.
    FullMatrix<double> inverse = K;
    for (unsigned int i = 0; i < K.m(); ++i)
      inverse(i, i) += 1e-6 * K.trace() / K.m();
    inverse.gauss_jordan();
    Vector<double> v(K.m()), Mv(K.m());
    for (unsigned int i = 0; i < v.size(); ++i)
      v[i] = std::sin(1. + i * i);
    double quotient = 0;
    for (unsigned int n_steps = 0; n_steps < 300; ++n_steps)
      {
        quotient = M.matrix_norm_square(v) / K.matrix_norm_square(v);
        CHECK(quotient < bound * (1 + 1e-4));
        M.vmult(Mv, v);
        inverse.vmult(v, Mv);
        v /= v.l2_norm();
      }
    CHECK(quotient > 0.98 * bound);
  }
} // namespace

TEST_CASE("the bound of the normal stress by the energy is sharp")
{
  for (const unsigned int degree : {1, 2})
    {
      check_bound<2>(degree);
      check_bound<3>(degree);
    }
}



TEST_CASE("a uniform stress is found at the contact points, none in rigid motions")
{
  for (const char *unbiased : {"no", "yes"})
    {
      const TwoBlocks<2> scene(*make_method("Nitsche", {{"Unbiased", unbiased}}), 2);
      // u_y = -c y in bodies of plane strain with sigma_yy = -c E (1-nu)/((1+nu)(1-2nu)).
      LA::Vector u = scene.elasticity.zero_vector();
      VectorTools::interpolate(scene.mesh.mapping(),
                               scene.elasticity.dof_handler(),
                               DisplacementFunction<2>(VectorExpression<2>("0; -y"), 0),
                               u);
      const LA::Vector s     = scene.contact->stress(u);
      const double     lower = 10 * 0.7 / (1.3 * 0.4), upper = 20 * 0.8 / (1.2 * 0.6);
      for (const auto i : s.locally_owned_elements())
        {
          CHECK(s(i) > 0.999999 * std::min(lower, upper));
          CHECK(s(i) < 1.000001 * std::max(lower, upper));
        }
      VectorTools::interpolate(scene.mesh.mapping(),
                               scene.elasticity.dof_handler(),
                               DisplacementFunction<2>(VectorExpression<2>("3-y; 2+x"), 0),
                               u);
      CHECK(scene.contact->stress(u).linfty_norm() < 1e-11);
    }
}



TEST_CASE("saddle point system is symmetric and consistent with gap and force")
{
  for (const unsigned int degree : {1, 2})
    {
      check_saddle_point<2>(degree);
      check_saddle_point<3>(degree);
    }
}



TEST_CASE("a contact pressure exerts balanced forces")
{
  const TwoBlocks<3> scene(*make_method("Lagrange multiplier"), 1);
  LA::Vector         p = scene.contact->zero();
  for (const auto i : p.locally_owned_elements())
    p(i) = 1 + std::sin(i);
  p.compress(VectorOperation::insert);
  // All components of all forces together: action and reaction.
  CHECK(std::abs(scene.contact->total_force(p, scene.contact->zero()).mean_value()) < 1e-14);
  // The gap does not change in rigid motions, so that the forces do no work: no moment either.
  for (const std::vector<double> &mode : scene.elasticity.rigid_body_modes())
    {
      LA::Vector u  = scene.elasticity.zero_vector();
      auto       at = mode.begin();
      for (const auto i : scene.elasticity.owned())
        u(i) = *at++;
      u.compress(VectorOperation::insert);
      LA::Vector change = scene.contact->gap(u);
      change -= scene.contact->initial_gap;
      CHECK(change.linfty_norm() < 1e-12);
    }
  // The points' areas sum up to the area of the slave, constant pressure to its resultant.
  CHECK(scene.contact->weight.l1_norm() == doctest::Approx(1));
}
