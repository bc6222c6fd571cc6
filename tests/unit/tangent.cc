// The linearised systems against finite differences of the nonlinear residual, on two blocks that
// overlap a little here and gap a little there, so that both states of contact occur.

#include <signorini/contact/gap_operator.h>
#include <signorini/contact/methods/lagrange_multiplier.h>
#include <signorini/contact/methods/penalty.h>
#include <signorini/elasticity/expression_function.h>
#include <signorini/parameters/section.h>
#include <signorini/solve/contact_system.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace Signorini;
using namespace dealii;

namespace
{
  template <int dim>
  BodyMesh<dim>
  box(const std::string &corners, const std::string &subdivisions)
  {
    RawSection raw;
    raw.set_value("Corners", corners, "test");
    raw.set_value("Subdivisions", subdivisions, "test");
    BodyMesh<dim> mesh;
    Section       section(raw);
    mesh.declare(section);
    return mesh;
  }

  template <int dim>
  struct TwoBlocks
  {
    TwoBlocks(const Sampling sampling, const unsigned int degree)
      : mesh(
          {{"lower", dim == 2 ? box<dim>("0,0 : 1,1", "4,3") : box<dim>("0,0,0 : 1,1,1", "3,3,2")},
           {"upper", dim == 2 ? box<dim>("0,1 : 1,2", "3,2") : box<dim>("0,0,1 : 1,1,2", "2,2,2")}},
          MeshSettings<dim>(),
          {{"upper.bottom", "lower.top"}},
          MPI_COMM_WORLD)
      , elasticity(mesh, {{10, 0.3}, {20, 0.2}}, supports(), {}, degree)
    {
      elasticity.setup();
      elasticity.assemble();
      ContactPair<dim> pair;
      pair.slave       = "upper.bottom";
      pair.master      = "lower.top";
      pair.initial_gap = "0.01*cos(5*x)";
      contact          = make_gap_operator<dim>(
        elasticity,
        {make_contact_surface<dim>(elasticity, pair, nullptr, {"quadrature", 3})},
        sampling);
    }

    static std::vector<Support<dim>>
    supports()
    {
      Support<dim> base;
      base.boundaries   = {"lower.bottom", "upper.top"};
      base.displacement = VectorExpression<dim>(dim == 2 ? "0;0" : "0;0;0");
      return {base};
    }

    /// Something smooth that has no symmetry, zero where displacements are prescribed.
    LA::Vector
    field(const double amplitude, const double frequency) const
    {
      const std::string a = std::to_string(amplitude), f = std::to_string(frequency);
      const std::string one = a + "*sin(" + f + "*(7*x+3*y))", two = a + "*cos(" + f + "*(5*x-y))";
      LA::Vector        u = elasticity.zero_vector();
      const VectorExpression<dim> expression(dim == 2 ? one + ";" + two :
                                                        one + ";" + two + ";" + one + "*" + two);
      VectorTools::interpolate(mesh.mapping(),
                               elasticity.dof_handler(),
                               DisplacementFunction<dim>(expression, 0),
                               u);
      elasticity.constraints().set_zero(u);
      return u;
    }

    Mesh<dim>                    mesh;
    Elasticity<dim>              elasticity;
    std::unique_ptr<GapOperator> contact;
  };

  /// K u - B^T W p(u), and the active set at u.
  template <int dim>
  LA::Vector
  internal_force(const TwoBlocks<dim> &scene,
                 const ContactMethod  &method,
                 const LA::Vector     &u,
                 LA::Vector           &active)
  {
    LA::Vector p = scene.contact->zero();
    apply_contact_law(method, *scene.contact, scene.contact->gap(u), p, p, active);
    LA::Vector r = scene.elasticity.zero_vector();
    scene.elasticity.stiffness().vmult(r, u);
    r -= scene.contact->force(p);
    scene.elasticity.constraints().set_zero(r);
    return r;
  }

  void
  set(Penalty &method, const std::string &weighting)
  {
    RawSection raw;
    raw.set_value("Factor", "5", "test");
    raw.set_value("Weighting", weighting, "test");
    Section section(raw);
    method.declare(section);
  }

  template <int dim>
  void
  check_penalty(const std::string &weighting, const unsigned int degree)
  {
    CAPTURE(dim);
    CAPTURE(weighting);
    CAPTURE(degree);
    Penalty method;
    set(method, weighting);
    const TwoBlocks<dim> scene(method.sampling(), degree);
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
    LagrangeMultiplier   method;
    const TwoBlocks<dim> scene(method.sampling(), degree);
    ContactSystem        system(scene.elasticity.stiffness(), *scene.contact, method);
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
    force -= scene.contact->force(pressure);
    force -= Ax.block(0);
    CHECK(force.l2_norm() < 1e-12 * Ax.block(0).l2_norm());
  }
} // namespace



TEST_CASE("tangent of the penalty method against finite differences")
{
  for (const char *weighting : {"mortar", "pointwise"})
    for (const unsigned int degree : {1, 2})
      {
        check_penalty<2>(weighting, degree);
        check_penalty<3>(weighting, degree);
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
  const TwoBlocks<3> scene(Sampling::nodes, 1);
  LA::Vector         p = scene.contact->zero();
  for (const auto i : p.locally_owned_elements())
    p(i) = 1 + std::sin(i);
  p.compress(VectorOperation::insert);
  // All components of all forces together: action and reaction.
  CHECK(std::abs(scene.contact->total_force(p).mean_value()) < 1e-14);
  // The points' areas sum up to the area of the slave, constant pressure to its resultant.
  CHECK(scene.contact->weight.l1_norm() == doctest::Approx(1));
}
