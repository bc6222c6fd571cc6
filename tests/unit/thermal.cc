// SPDX-License-Identifier: Apache-2.0
// Thermal strain against closed forms: free bodies, held bodies, normal stresses at contact points.

#include "contact/laws/normal_contact.h"
#include "mesh_import/mesh_file.h"
#include "solid/rigid_body_modes.h"
#include "solid/stress.h"

#include <doctest/doctest.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "source_directory.h"
#include "two_blocks.h"

using namespace Signorini;
using namespace dealii;
using namespace TestScene;

namespace
{
  template <int dim>
  ThermalExpansion<dim>
  expansion(const std::string &coefficients,
            const std::string &temperature,
            const std::string &reference = "0")
  {
    RawSection raw;
    raw.set_value("Thermal expansion", coefficients, "test");
    raw.set_value("Temperature", temperature, "test");
    raw.set_value("Reference temperature", reference, "test");
    ThermalExpansion<dim> result;
    Section               section(raw);
    result.declare(section, false);
    return result;
  }

  template <int dim>
  Model
  first_model()
  {
    return dim == 2 ? Model::plane_strain : Model::solid;
  }

  /// A box that planes of symmetry hold at x = 0, y = 0, z = 0, or that is held on all sides, or
  /// not at all.
  template <int dim>
  struct Block
  {
    Block(const ThermalExpansion<dim>    &expansion,
          const std::vector<std::string> &held,
          const unsigned int              degree,
          const Model                     model          = first_model<dim>(),
          const std::string              &transformation = "")
      : mesh({{"block", body(transformation)}}, geometry(degree), {}, MPI_COMM_WORLD)
      , elasticity(mesh,
                   {{7, 0.3}},
                   supports(held),
                   {},
                   {degree},
                   model,
                   {},
                   Elasticity<dim>::default_stabilisation,
                   {expansion})
    {
      elasticity.setup();
      elasticity.assemble();
      elasticity.set_time(1);
    }

    /// Isoparametric, so that the displacement of uniform expansion can be expressed.
    static MeshSettings<dim>
    geometry(const unsigned int degree)
    {
      MeshSettings<dim> settings;
      settings.geometry_degree = degree;
      return settings;
    }

    static BodyMesh<dim>
    body(const std::string &transformation)
    {
      BodyMesh<dim> mesh =
        dim == 2 ? box<dim>("0,0 : 2,1", "4,3") : box<dim>("0,0,0 : 2,1,1", "4,2,2");
      mesh.transformation = VectorExpression<dim>(transformation);
      return mesh;
    }

    static std::vector<Support<dim>>
    supports(const std::vector<std::string> &held)
    {
      std::vector<Support<dim>> result;
      for (const std::string &boundary : held)
        {
          Support<dim> one;
          one.boundaries = {"block." + boundary};
          one.type       = SupportType::symmetry;
          result.push_back(one);
        }
      return result;
    }

    LA::Vector
    interpolated(const std::string &u) const
    {
      LA::Vector result = elasticity.zero_vector();
      VectorTools::interpolate(mesh.mapping(),
                               elasticity.dof_handler(),
                               DisplacementFunction<dim>(VectorExpression<dim>(u), 1),
                               result);
      return result;
    }

    /// Of the forces of thermal strain, relative to them, at a displacement. The springs of free
    /// motions are no part of the body.
    double
    imbalance(const std::string &displacement) const
    {
      const LA::Vector f = elasticity.load(), u = interpolated(displacement);
      LA::Vector       r = elasticity.zero_vector();
      elasticity.stiffness().vmult(r, u);
      if (elasticity.has_unsupported_modes())
        {
          LA::Vector springs = elasticity.stabilising_stiffness();
          springs.scale(u);
          r -= springs;
        }
      elasticity.constraints().set_zero(r);
      r -= f;
      return r.l2_norm() / f.l2_norm();
    }

    /// Calls visit(stress, x) at points of all cells.
    template <typename Visit>
    void
    at_points(const std::string &displacement, const Visit &visit) const
    {
      const LA::Vector u = elasticity.with_ghosts(interpolated(displacement));
      FEValues<dim>    values(mesh.mapping(),
                           elasticity.finite_elements()[0],
                           QIterated<dim>(QTrapezoid<1>(), 2),
                           update_values | update_gradients | update_quadrature_points);
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            values.reinit(cell);
            std::vector<Tensor<1, dim>> us(values.n_quadrature_points);
            std::vector<Tensor<2, dim>> gradients(values.n_quadrature_points);
            values[FEValuesExtractors::Vector(0)].get_function_values(u, us);
            values[FEValuesExtractors::Vector(0)].get_function_gradients(u, gradients);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const Point<dim> &x = values.quadrature_point(q);
                visit(elasticity.stress(*cell, gradients[q], us[q], x), x);
              }
          }
    }

    Mesh<dim>       mesh;
    Elasticity<dim> elasticity;
  };

  template <int dim>
  std::vector<std::string>
  planes_of_symmetry()
  {
    if (dim == 2)
      return {"left", "bottom"};
    return {"left", "front", "bottom"};
  }

  const SymmetricTensor<2, 3> no_stress;
} // namespace



TEST_CASE("a body that expands freely is free of stress: uniform temperature, distorted cells")
{
  for (const unsigned int degree : {1, 2})
    {
      CAPTURE(degree);
      const auto check = [](const auto &block, const std::string &u, const auto &wanted) {
        CHECK(block.imbalance(u) < 1e-13);
        block.at_points(u, [&](const auto &stress, const auto &) {
          CHECK((stress - wanted).norm() < 1e-13);
        });
      };
      const auto        along_axes = expansion<3>("1e-3, 2e-3, 4e-3", "20 + 30*t", "40");
      const std::string bent       = "x + 0.1*sin(3*x*y); y + 0.1*x*y*(1-y); z";
      check(Block<3>(along_axes, planes_of_symmetry<3>(), degree, Model::solid, bent),
            "0.01*x; 0.02*y; 0.04*z",
            no_stress);

      const auto        plane = expansion<2>("1e-3, 2e-3, 4e-3", "20 + 30*t", "40");
      const std::string wavy  = "x + 0.1*sin(3*x*y); y + 0.1*x*y*(1-y)";
      check(Block<2>(plane, planes_of_symmetry<2>(), degree, Model::plane_stress, wavy),
            "0.01*x; 0.02*y",
            no_stress);
      // What sigma_zz = - E alpha_z rise does: nu alpha_z more in the plane.
      SymmetricTensor<2, 3> out_of_plane;
      out_of_plane[2][2] = -7 * 0.04;
      check(Block<2>(plane, planes_of_symmetry<2>(), degree, Model::plane_strain, wavy),
            "(0.01 + 0.3*0.04)*x; (0.02 + 0.3*0.04)*y",
            out_of_plane);
      check(Block<2>(expansion<2>("1e-3, 2e-3, 1e-3", "10"),
                     planes_of_symmetry<2>(),
                     degree,
                     Model::axisymmetric,
                     wavy),
            "0.01*x; 0.02*y",
            no_stress);
    }
}



TEST_CASE("a free body with a linear temperature is free of stress, and parabolic")
{
  const auto check = [](const auto &block, const std::string &u, const auto &wanted) {
    CHECK(block.imbalance(u) < 1e-13);
    block.at_points(u, [&](const auto &stress, const auto &x) {
      CHECK((stress - wanted(x[0])).norm() < 1e-13);
    });
  };
  const auto none = [](double) { return no_stress; };
  check(Block<3>(expansion<3>("1e-2", "3*x"), {"front", "bottom"}, 2),
        "0.015*(x^2-y^2-z^2); 0.03*x*y; 0.03*x*z",
        none);
  check(Block<2>(expansion<2>("1e-2", "3*x"), {"bottom"}, 2, Model::plane_stress),
        "0.015*(x^2-y^2); 0.03*x*y",
        none);
  check(Block<2>(expansion<2>("1e-2", "3*x"), {"bottom"}, 2, Model::plane_strain),
        "1.3*0.015*(x^2-y^2); 1.3*0.03*x*y",
        [](const double x) {
          SymmetricTensor<2, 3> stress;
          stress[2][2] = -7 * 0.03 * x;
          return stress;
        });
  check(Block<2>(expansion<2>("1e-2", "3*y"), {"left"}, 2, Model::axisymmetric),
        "0.03*x*y; 0.015*(y^2-x^2)",
        none);
}



TEST_CASE("a body that cannot expand has the stress of its model")
{
  const double E = 7, nu = 0.3, strain = 1e-3 * 50;
  const auto   check =
    [](const auto &block, const std::string &u, const double in_plane, const double out) {
      block.at_points(u, [&](const auto &stress, const auto &) {
        CHECK(stress[0][0] == doctest::Approx(in_plane));
        CHECK(stress[1][1] == doctest::Approx(in_plane));
        CHECK(stress[2][2] == doctest::Approx(out));
        CHECK(std::abs(stress[0][1]) < 1e-14);
      });
    };
  const double all_around = -E * strain / (1 - 2 * nu), sheet = -E * strain / (1 - nu);
  const auto   heat = expansion<2>("1e-3", "50");
  check(Block<3>(expansion<3>("1e-3", "50"), {"left"}, 1), "0;0;0", all_around, all_around);
  check(Block<2>(heat, {"left"}, 1, Model::plane_strain), "0;0", all_around, all_around);
  check(Block<2>(heat, {"left"}, 1, Model::plane_stress), "0;0", sheet, 0);
  check(Block<2>(heat, {"left"}, 1, Model::axisymmetric), "0;0", all_around, all_around);
}



namespace
{
  template <int dim>
  void
  check_resultant(const Model model, const unsigned int degree)
  {
    // No supports: the load is what thermal strain exerts at all nodes.
    const std::string   temperature = dim == 2 ? "exp(x*y) + 7*t" : "exp(x*y) - z^3 + 7*t";
    const Block<dim>    block(expansion<dim>("1e-3, 2e-3, 4e-3", temperature), {}, degree, model);
    const LA::Vector    f = block.elasticity.load();
    std::vector<double> sizes;
    for (const std::vector<double> &mode : rigid_body_modes(block.elasticity))
      {
        double work = 0;
        auto   at   = mode.begin();
        for (const auto i : block.elasticity.owned())
          work += *at++ * f(i);
        sizes.push_back(std::abs(Utilities::MPI::sum(work, MPI_COMM_WORLD)) / f.l1_norm());
      }
    if (model == Model::axisymmetric)
      sizes = {sizes[1]}; // along the axis
    else
      CHECK(sizes.size() == (dim == 2 ? 3 : 6));
    for (const double size : sizes)
      CHECK(size < 1e-14);
  }
} // namespace

TEST_CASE("forces of thermal strain have no resultant")
{
  for (const unsigned int degree : {1, 2})
    {
      check_resultant<2>(Model::plane_strain, degree);
      check_resultant<2>(Model::plane_stress, degree);
      check_resultant<2>(Model::axisymmetric, degree);
      check_resultant<3>(Model::solid, degree);
    }
}



TEST_CASE("a temperature within cells is fitted with one degree less than the displacement")
{
  // On [0, 1/2]: the mean of x^3 is 1/32; its best line is 9/40 x - 1/40.
  for (const unsigned int degree : {1, 2})
    {
      const Block<2> block(expansion<2>("1", "x^3"), {"left"}, degree);
      for (const auto &cell : block.mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned() && cell->center()[0] < 0.5)
          for (const double x : {0., 0.2, 0.5})
            CHECK(block.elasticity.thermal().temperature_change(*cell, {x, cell->center()[1]}) ==
                  doctest::Approx(degree == 1 ? 1. / 32 : 9 * x / 40 - 1. / 40));
    }
}



namespace
{
  /// Two blocks of different meshes, one on the other, that planes of symmetry hold on all sides.
  template <int dim>
  struct HeatedPair
  {
    HeatedPair(const ContactMethod &method, const unsigned int degree)
      : mesh(
          {{"lower", dim == 2 ? box<dim>("0,0 : 1,1", "4,3") : box<dim>("0,0,0 : 1,1,1", "3,3,2")},
           {"upper", dim == 2 ? box<dim>("0,1 : 1,3", "3,2") : box<dim>("0,0,1 : 1,1,3", "2,2,2")}},
          MeshSettings<dim>(),
          {{"upper.bottom", "lower.top"}},
          MPI_COMM_WORLD)
      , elasticity(mesh,
                   {lower, upper},
                   {sides()},
                   {},
                   {degree},
                   first_model<dim>(),
                   {},
                   Elasticity<dim>::default_stabilisation,
                   {expansion<dim>("2e-3", "5 + 10*t", "5"), expansion<dim>("3e-3", "-4*t")})
    {
      elasticity.setup();
      elasticity.assemble();
      ContactPair<dim> pair;
      pair.slave       = "upper.bottom";
      pair.master      = "lower.top";
      pair.initial_gap = "closed";
      contact =
        make_gap_operator<dim>(elasticity,
                               {make_contact_surface<dim>(
                                 elasticity, pair, nullptr, method, {Rule::segments, degree + 1})},
                               method);
      elasticity.set_time(1);
      contact->set_temperature_change(elasticity.thermal().coefficients());
    }

    static Support<dim>
    sides()
    {
      Support<dim> one;
      one.type = SupportType::symmetry;
      for (const std::string body : {"lower.", "upper."})
        for (const std::string boundary : {"left", "right"})
          one.boundaries.push_back(body + boundary);
      one.boundaries.push_back("lower.bottom");
      one.boundaries.push_back("upper.top");
      if (dim == 3)
        for (const std::string body : {"lower.", "upper."})
          for (const std::string boundary : {"front", "back"})
            one.boundaries.push_back(body + boundary);
      return one;
    }

    // With p = alpha rise E/(1 - 2 nu) - (lambda + 2 mu) eps in both, whose heights 1 and 2 make
    // eps_lower + 2 eps_upper = 0.
    double
    pressure() const
    {
      return (hindered(lower, 0.02) / modulus(lower) +
              2 * hindered(upper, -0.012) / modulus(upper)) /
             (1 / modulus(lower) + 2 / modulus(upper));
    }

    LA::Vector
    displacement() const
    {
      const double strain_lower = (hindered(lower, 0.02) - pressure()) / modulus(lower),
                   strain_upper = (hindered(upper, -0.012) - pressure()) / modulus(upper);
      const std::string  up     = dim == 2 ? "y" : "z";
      std::ostringstream u;
      u << std::setprecision(17) << "if(" << up << "<=1, " << up << "*(" << strain_lower << "), ("
        << up << "-3)*(" << strain_upper << "))";
      LA::Vector result = elasticity.zero_vector();
      VectorTools::interpolate(
        mesh.mapping(),
        elasticity.dof_handler(),
        DisplacementFunction<dim>(VectorExpression<dim>((dim == 2 ? "0;" : "0;0;") + u.str()), 1),
        result);
      return result;
    }

    static double
    modulus(const Material &material)
    {
      return material.lambda() + 2 * material.mu();
    }

    static double
    hindered(const Material &material, const double strain)
    {
      return material.youngs_modulus / (1 - 2 * material.poissons_ratio) * strain;
    }

    const Material               lower{10, 0.3}, upper{20, 0.2};
    Mesh<dim>                    mesh;
    Elasticity<dim>              elasticity;
    std::unique_ptr<GapOperator> contact;
  };

  template <int dim>
  void
  check_contact(const std::string &theta, const std::string &unbiased, const unsigned int degree)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    CAPTURE(theta);
    CAPTURE(unbiased);
    const auto method = make_method("Nitsche", {{"Theta", theta}, {"Unbiased", unbiased}});
    const HeatedPair<dim> scene(*method, degree);
    const LA::Vector      u = scene.displacement(), s = scene.contact->stress(u)[0];
    const double          p = scene.pressure();
    REQUIRE(p > 0);
    for (const auto i : s.locally_owned_elements())
      CHECK(std::abs(s(i) - p) < 1e-12 * p); // the difference of stresses ten times as large
    LA::Vector active = scene.contact->zero(), r = scene.elasticity.zero_vector();
    active                    = 1.;
    const LA::Vector gap      = scene.contact->gap(u),
                     pressure = NormalContact(*method, *scene.contact)
                                  .traction({{gap}, {s}, {s}, {}}, active)[0];
    scene.elasticity.stiffness().vmult(r, u);
    const LA::Vector f = scene.elasticity.load();
    r -= f;
    r -= scene.contact->force({pressure}, {s});
    scene.elasticity.constraints().set_zero(r);
    CHECK(r.l2_norm() < 1e-13 * f.l2_norm());
  }
} // namespace

TEST_CASE("Nitsche's method is in balance at the exact solution of heated blocks")
{
  for (const char *theta : {"1", "0", "-1"})
    for (const char *unbiased : {"no", "yes"})
      for (const unsigned int degree : {1, 2})
        {
          check_contact<2>(theta, unbiased, degree);
          check_contact<3>(theta, unbiased, degree);
        }
}



TEST_CASE("what is said of the temperature must be complete")
{
  using Keys       = std::vector<std::pair<std::string, std::string>>;
  const auto reads = [](const Keys &keys, const bool with_field) {
    RawSection raw;
    for (const auto &[key, value] : keys)
      raw.set_value(key, value, "test");
    ThermalExpansion<2> one;
    Section             section(raw);
    one.declare(section, with_field);
    return one;
  };
  CHECK(!reads({}, false).given());
  CHECK_THROWS_AS(reads({{"Thermal expansion", "1e-5"}}, false), SceneError);
  CHECK_THROWS_AS(reads({{"Temperature", "100"}}, false), SceneError);
  CHECK_THROWS_AS(reads({}, true), SceneError);
  CHECK_THROWS_AS(reads({{"Thermal expansion", "1, 2"}, {"Temperature", "1"}}, false), SceneError);
  CHECK_THROWS_AS(reads({{"Thermal expansion", "1"}, {"Temperature", "field"}}, false), SceneError);
  CHECK_THROWS_AS(reads({{"Thermal expansion", "1"}, {"Temperature", "x"}}, true), SceneError);

  const auto of_file = reads({{"Thermal expansion", "1"}}, true);
  CHECK(of_file.depends_on_field());
  CHECK(of_file.depends_on_place());
  CHECK(!of_file.depends_on_time());
  CHECK(of_file.value({3, 4}, 5, 6) == 6);
  const auto ramped = reads({{"Thermal expansion", "1"}, {"Temperature", "x*t*field"}}, true);
  CHECK(ramped.depends_on_time());
  CHECK(ramped.value({3, 4}, 5, 6) == 90);
  const auto uniform = reads({{"Thermal expansion", "1"}, {"Temperature", "7*t"}}, false);
  CHECK(!uniform.depends_on_place());
  CHECK(uniform.alpha()[2] == 1);
}



namespace
{
  template <int dim>
  void
  check_coarse_field(const Distribution distribution)
  {
    // Multilinear in the box: what its cells make of the values at their vertices.
    const auto f = [](const Point<dim> &x) {
      double product = 2;
      for (unsigned int d = 0; d < dim; ++d)
        product *= 1 + (d + 1) * x[d];
      return product;
    };
    const BodyMesh<dim> other = box<dim>(dim == 2 ? "0,0 : 1,1" : "0,0,0 : 1,1,1",
                                         dim == 2 ? "1,1" : "1,1,1"),
                        body = box<dim>(dim == 2 ? "2,0 : 4,3" : "2,0,0 : 4,3,1",
                                        dim == 2 ? "4,3" : "2,3,1");
    MeshSettings<dim> settings;
    settings.refinements  = 2;
    settings.distribution = distribution;
    const Mesh<dim>       mesh({{"other", other}, {"body", body}}, settings, {}, MPI_COMM_WORLD);
    const CoarseMesh<dim> coarse = body.generator->generate();
    std::vector<double>   values;
    for (const Point<dim> &vertex : coarse.vertices)
      values.push_back(f(vertex));
    CoarseField<dim> field;
    field.append(other.generator->generate().cells, {});
    field.append(coarse.cells, values);
    if (distribution == Distribution::p4est) // has an order of its own; METIS keeps the numbers
      {
        std::vector<types::coarse_cell_id> ids(mesh.triangulation().n_cells(0));
        for (const auto &cell : mesh.triangulation().cell_iterators_on_level(0))
          ids[cell->index()] = cell->id().get_coarse_cell_id();
        field.number(ids);
      }
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const double place : {0., 0.3, 1.})
          {
            Point<dim> unit;
            for (unsigned int d = 0; d < dim; ++d)
              unit[d] = d == 0 ? place : 0.6;
            const double found = field.value(cell->id(), unit);
            if (cell->material_id() == 0)
              CHECK(std::isnan(found));
            else
              CHECK(found ==
                    doctest::Approx(f(mesh.mapping().transform_unit_to_real_cell(cell, unit))));
          }
  }
} // namespace

TEST_CASE("a field on coarse cells is found on refined ones")
{
  for (const Distribution distribution : {Distribution::p4est, Distribution::METIS})
    {
      check_coarse_field<2>(distribution);
      check_coarse_field<3>(distribution);
    }
}



TEST_CASE("numbers at the nodes of mesh files")
{
  for (const char *name : {"heated.vtu", "heated.vtk", "heated.msh"})
    {
      const MeshFile file = read_mesh_file(source_directory() + "/tests/meshes/" + name);
      CAPTURE(name);
      REQUIRE(file.fields.size() == 2); // not the vectors
      const std::vector<double> &heat = file.fields.at("heat"), &number = file.fields.at("number");
      REQUIRE(heat.size() == file.nodes.size());
      for (unsigned int i = 0; i < heat.size(); ++i)
        {
          CHECK(heat[i] == doctest::Approx(50 + 20 * file.nodes[i][0]));
          CHECK(number[i] == i);
        }
    }
}
