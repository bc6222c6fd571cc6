// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/import_deck.h"
#include "mesh_import/formats/abaqus.h"
#include "mesh_import/formats/rigid_motion.h"
#include "mesh_import/pieces.h"
#include "solid/cell_nodes.h"
#include "solid/elasticity.h"
#include "solid/resultant.h"
#include <signorini/scene/scene.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>

#include "deck_helpers.h"
#include "mesh_helpers.h"

using namespace dealii;
using namespace Signorini;
using namespace MeshTests;
using namespace DeckTests;

namespace
{
  const std::string cube = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n"
                           "6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n*ELEMENT, TYPE=C3D8\n"
                           "1, 1, 2, 3, 4, 5, 6, 7, 8\n";

  const std::string of_cube = "*MATERIAL, NAME=m\n*ELASTIC\n100, 0.3\n";
} // namespace



TEST_CASE("rotations are right-handed, and leave lengths and the axis alone")
{
  const auto quarter = RigidMotion::about_axis({1, 0, 0}, {1, 0, 5}, numbers::PI / 2);
  CHECK(quarter({2, 0, 3}).distance(Point<3>(1, 1, 3)) < 1e-14);
  CHECK(quarter({1, 0, 7}).distance(Point<3>(1, 0, 7)) < 1e-14);
  const auto     skew = RigidMotion::about_axis({1, 2, 3}, {3, 3, 1}, 0.7);
  const Point<3> on_axis(1 + 2 * 1.5, 2 + 1.5, 3 - 2 * 1.5), a(4, -1, 2), b(0, 3, 3);
  CHECK(skew(on_axis).distance(on_axis) < 1e-14);
  CHECK(std::abs(skew(a).distance(skew(b)) - a.distance(b)) < 1e-14);
  CHECK(std::abs(determinant(skew.rotation) - 1) < 1e-14);
  // The angle, measured across the axis.
  const Tensor<1, 3> n = (Point<3>(3, 3, 1) - Point<3>(1, 2, 3)) / 3., arm = a - on_axis;
  const Tensor<1, 3> before = arm - (arm * n) * n, after = skew(a) - on_axis - (arm * n) * n;
  CHECK(std::abs(cross_product_3d(before, after) * n / before.norm_square() - std::sin(0.7)) <
        1e-13);
  const auto both = quarter.then(RigidMotion::translation(Point<3>(0, 0, 1)));
  CHECK(both({2, 0, 3}).distance(Point<3>(1, 1, 4)) < 1e-14);
}



TEST_CASE("parts and instances: places, sets and surfaces of each")
{
  const MeshFile file = read_abaqus(test_mesh("cae-blocks.inp"));
  CHECK(file.nodes.size() == 12);
  CHECK(part_names(file, 2) == std::vector<std::string>{"Block-1",
                                                        "Block-2",
                                                        "Block-1.Set-1",
                                                        "Block-1._Left_S4",
                                                        "Block-1._Right_S2",
                                                        "Block-2.Set-1",
                                                        "Block-2._Left_S4",
                                                        "Block-2._Right_S2"});
  // The part's (5,6) comes to lie at (6,0) and (6,5).
  CHECK(file.nodes[3].distance(Point<3>(6, 0, 0)) < 1e-14);
  CHECK(file.nodes[9].distance(Point<3>(6, 5, 0)) < 1e-14);
  CHECK(group(file, "base").nodes == MeshFile::Nodes{1, 3, 5});
  CHECK(group(file, "press").nodes == MeshFile::Nodes{6, 8, 10});
  CHECK(group(file, "side").nodes == MeshFile::Nodes{0, 1, 6, 7});
  CHECK(group(file, "Block-2.One").nodes == MeshFile::Nodes{6, 8, 10});
  CHECK(group(file, "Block-2.Right").faces.size() == 2);

  const auto mesh =
    generator<2>("file", {{"File", test_mesh("cae-blocks.inp")}, {"Part", "Block-2"}})->generate();
  CHECK(
    mesh.boundaries ==
    std::vector<std::string>{
      "Block-2.Left", "Block-2.Right", "Block-2.One", "Block-2.Other", "press", "side", "unnamed"});
}



TEST_CASE("parts and instances: what is wrong is named")
{
  const auto attempt = [](const std::string &text) {
    const TemporaryFile file(text, ".inp");
    return message_of([&] { read_abaqus(file.path); });
  };
  const std::string part = "*PART, NAME=a\n" + cube + "*END PART\n";
  says(attempt(part + "*INSTANCE, NAME=a-1, PART=b\n*END INSTANCE\n"), "there is no part 'b'");
  says(attempt(part + part), "the part 'a' is there twice");
  says(attempt(part + "*INSTANCE, NAME=i, PART=a\n*END INSTANCE\n*INSTANCE, NAME=I, PART=a\n"
                      "*END INSTANCE\n"),
       "the instance 'I' is there twice");
  says(attempt(part + "*INSTANCE, NAME=i, PART=a\n0,0,0\n1,1,1, 1,1,1, 90\n*END INSTANCE\n"),
       "the two points of the axis of rotation are the same");
  says(attempt(part + "*INSTANCE, NAME=i, PART=a\n"), "without its end");
  says(attempt(part + "*INSTANCE, NAME=i, PART=a\n*END INSTANCE\n*NSET, NSET=n, INSTANCE=j\n1\n"),
       "there is no instance 'j'");
}



TEST_CASE("keywords in any spelling, data in other files")
{
  const TemporaryFile nodes("1, 0, 0\n2, 1, 0\n** a comment\n3, 1, 1\n", ".nodes");
  const std::string   name = std::filesystem::path(nodes.path).filename().string();
  const TemporaryFile file("\xEF\xBB\xBF*heading\n* Node ,  Nset = all ,\n INPUT=" + name +
                             "\r\n4, 0,\t1\r\n*element, type = cpe4 , Elset=E\r\n1,1,2,3,4\r\n"
                             "*Surface, name=s, combine=union\n",
                           ".inp");
  const MeshFile      mesh = read_abaqus(file.path);
  CHECK(mesh.nodes.size() == 4);
  CHECK(mesh.nodes[3] == Point<3>(0, 1, 0));
  CHECK(group(mesh, "all").nodes.size() == 4);
}



TEST_CASE("nodes and elements made of others")
{
  // A row of 2 x 3 squares, turned into the plane x = 2 by *SYSTEM.
  const TemporaryFile file(
    "*SYSTEM\n2, 0, 0, 2, 1, 0, 2, 0, 1\n*NODE\n1, 0, 0\n3, 2, 0\n"
    "31, 0, 3\n33, 2, 3\n*NGEN, NSET=low\n1, 3, 1\n*NGEN, NSET=high\n31, 33\n"
    "*NFILL, NSET=all\nlow, high, 3, 10\n*ELEMENT, TYPE=S4\n"
    "1, 1, 2, 12, 11\n*ELGEN, ELSET=skin\n1, 2, 1, 1, 3, 10, 10\n"
    "*NCOPY, CHANGE NUMBER=100, OLD SET=all, SHIFT, NEW SET=copy\n0, 0, 5\n"
    "*ELCOPY, ELEMENT SHIFT=100, OLD SET=skin, SHIFT NODES=100, NEW SET=far\n",
    ".inp");
  const AbaqusDeck deck = read_abaqus_deck(file.path);
  CHECK(deck.mesh.nodes.size() == 24);
  CHECK(deck.mesh.elements.size() == 12);
  const auto place = [&](const std::size_t n) { return deck.mesh.nodes[deck.nodes.index(n)]; };
  CHECK(place(22).distance(Point<3>(2, 1, 2)) < 1e-14);
  CHECK(place(122).distance(Point<3>(2, 1, 7)) < 1e-14);
  CHECK(deck.elements.find("skin")->members.size() == 6);
  CHECK(deck.elements.find("far")->members.size() == 6);
  const auto &last = deck.mesh.elements[deck.elements.index(122)];
  CHECK(deck.mesh.nodes[last.nodes[2]].distance(Point<3>(2, 2, 8)) < 1e-14);

  const TemporaryFile round("*NODE, SYSTEM=C\n1, 2, 90, 3\n*NODE, SYSTEM=S\n2, 2, 0, 90\n"
                            "*NODE\n3, 5, 5, 5\n*NFILL, BIAS=0.5\n1, 3, 2, 10\n"
                            "*ELEMENT, TYPE=MASS\n1, 1\n",
                            ".inp");
  const AbaqusDeck    polar = read_abaqus_deck(round.path);
  CHECK(polar.mesh.nodes[0].distance(Point<3>(0, 2, 3)) < 1e-14);
  CHECK(polar.mesh.nodes[1].distance(Point<3>(0, 0, 2)) < 1e-14);
  // Intervals of 1 and 2 thirds.
  const Point<3> between = polar.mesh.nodes[polar.nodes.index(11)];
  CHECK(between.distance(Point<3>(0, 2, 3) + (Point<3>(5, 5, 5) - Point<3>(0, 2, 3)) / 3.) < 1e-14);
}



TEST_CASE("pieces are parts; those that touch need a pair; faces have several names")
{
  MeshFile file = read_abaqus(test_mesh("pieces.inp"));
  add_pieces(file, 2);
  CHECK(part_names(file, 2) == std::vector<std::string>{"Eall", "piece1", "piece2"});
  CHECK(group(file, "piece2").elements == std::vector<unsigned int>{2, 3});

  const Keys whole{{"File", test_mesh("pieces.inp")}};
  const auto all = generator<2>("file", whole);
  says(all->needs_pair(), "3 pairs, the first at (");
  const CoarseMesh<2> mesh = all->generate();
  const auto          name = [&](const std::string &wanted) {
    return std::find(mesh.boundaries.begin(), mesh.boundaries.end(), wanted) -
           mesh.boundaries.begin();
  };
  CHECK(mesh.ids_of(name("Sslav")) == mesh.ids_of(name("Nslav")));
  CHECK(mesh.n_boundary_ids() == mesh.names_of_ids.size());

  const auto upper = generator<2>("file", {{"File", test_mesh("pieces.inp")}, {"Part", "piece2"}});
  CHECK(upper->needs_pair().empty());
  CHECK(upper->generate().cells.size() == 2);
  CHECK(upper->node_set("Nbase").nodes.empty());
  CHECK(upper->node_set("Nends").nodes.size() == 2);
  // A node in the middle of an edge has the place of the middle; the middle one is in two cells.
  const auto middles = upper->node_set("Nmiddles").nodes;
  REQUIRE(middles.size() == 2);
  CHECK(middles[0].size() == 1);
  const Point<2> unit = middles[0][0].unit;
  CHECK(std::min({std::abs(unit[0] - 0.5), std::abs(unit[1] - 0.5)}) == 0);
  bool found = false;
  for (unsigned int n = 1; n < 30; ++n)
    found |= upper->node_set(std::to_string(n)).nodes.size() == 1 &&
             upper->node_set(std::to_string(n)).nodes[0].size() == 2;
  CHECK(found);
  CHECK(upper->node_set("99").nodes.empty());
}



TEST_CASE_TEMPLATE("forces at nodes and points keep their sum and moment, on any mesh",
                   T,
                   std::integral_constant<int, 2>,
                   std::integral_constant<int, 3>)
{
  constexpr int dim = T::value;
  for (const unsigned int degree : {1u, 2u})
    {
      BodyMesh<dim> body;
      RawSection    raw;
      raw.set_value("Corners", dim == 2 ? "0,0 : 2,1" : "0,0,0 : 2,1,1", "test");
      raw.set_value("Subdivisions", dim == 2 ? "2,1" : "2,1,1", "test");
      Section section(raw);
      body.declare(section);
      MeshSettings<dim> settings;
      settings.refinement_regions.resize(1);
      settings.refinement_regions[0].where = Expression<dim>("1 - x");
      const Mesh<dim> mesh({{"block", body}}, settings, {}, MPI_COMM_WORLD);

      std::vector<Load<dim>> loads(2);
      loads[0].nodes.point = {1, 0.5, 0.25}; // on a face with hanging nodes
      loads[1].nodes.point = {1.3, 1, 0.4};
      for (Load<dim> &load : loads)
        {
          load.nodes.point.resize(dim);
          load.force = VectorExpression<dim>(dim == 2 ? "3*t; -2" : "3*t; -2; 5");
        }
      Elasticity<dim> elasticity(mesh, std::vector<Material>(1), {}, loads, {degree});
      elasticity.setup();
      elasticity.set_time(2);
      LA::Vector                           f       = elasticity.load();
      const auto                           ghosted = elasticity.with_ghosts(f);
      Tensor<1, dim>                       force, wanted;
      Tensor<1, 3>                         moment, wanted_moment;
      CellNodes<dim>                       nodes_of(mesh, elasticity.finite_elements());
      std::set<types::global_dof_index>    done;
      std::vector<types::global_dof_index> indices;
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const std::vector<Point<dim>> nodes = nodes_of(cell);
            read_indices<dim>(cell, indices);
            for (unsigned int i = 0; i < indices.size(); ++i)
              if (elasticity.owned().is_element(indices[i]) && done.insert(indices[i]).second)
                {
                  Tensor<1, dim> one;
                  one[cell->get_fe().system_to_component_index(i).first] = ghosted(indices[i]);
                  force += one;
                  moment += moment_of(nodes[i], one);
                }
          }
      force  = Utilities::MPI::sum(force, MPI_COMM_WORLD);
      moment = Utilities::MPI::sum(moment, MPI_COMM_WORLD);
      for (const Load<dim> &load : loads)
        {
          Point<dim> x;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] = load.nodes.point[d];
          wanted += load.force.value(x, 2);
          wanted_moment += moment_of(x, load.force.value(x, 2));
        }
      CHECK((force - wanted).norm() < 1e-12);
      CHECK((moment - wanted_moment).norm() < 1e-12);
    }
}



TEST_CASE("a force on each node of a set is not one on nodes that divided cells have beside")
{
  // tetrahedra.inp: 4 x 4 nodes at the base of `lower`, of first order; 3 x 4 and the middles of
  // the edges of their triangles at `press`, of second order.
  for (const auto &[part, set, n] :
       std::vector<std::tuple<std::string, std::string, unsigned int>>{{"lower", "base", 16},
                                                                       {"upper", "press", 35}})
    for (const bool total : {false, true})
      {
        CAPTURE(part);
        BodyMesh<3> body;
        RawSection  raw;
        raw.set_value("Mesh", "file", "test");
        raw.set_value("File", stored_mesh("tetrahedra.inp"), "test");
        raw.set_value("Part", part, "test");
        Section section(raw);
        body.declare(section);
        body.generator->read_file("", "the test");
        const Mesh<3>        mesh({{"block", body}}, {}, {}, MPI_COMM_WORLD);
        std::vector<Load<3>> loads(1);
        loads[0].nodes.sets                             = {"block." + set};
        (total ? loads[0].total_force : loads[0].force) = VectorExpression<3>("0; 0; 3*t");
        Elasticity<3> elasticity(mesh, std::vector<Material>(1), {}, loads, {1});
        elasticity.setup();
        elasticity.set_time(2);
        LA::Vector ones = elasticity.zero_vector();
        ones            = 1.;
        CHECK(elasticity.load() * ones == doctest::Approx(total ? 6. : 6. * n));
      }
}



TEST_CASE("import: isotropic moduli in the form of orthotropic ones")
{
  // lambda + 2 mu, lambda, lambda + 2 mu, lambda, lambda, lambda + 2 mu, mu of E = 210, nu = 0.3.
  const TemporaryFile file(cube + "*ELSET, ELSET=e\n1\n*MATERIAL, NAME=m\n*ELASTIC, TYPE=ORTHO\n"
                                  "282.692307692, 121.153846154, 282.692307692, 121.153846154, "
                                  "121.153846154, 282.692307692, 80.7692307692, 80.7692307692\n"
                                  "80.7692307692\n*SOLID SECTION, ELSET=e, MATERIAL=m\n",
                           ".inp");
  const Scene<3>      scene    = checked<3>(imported(file.path).first);
  const Material     &material = scene.bodies[0].material;
  CHECK(material.youngs_modulus == doctest::Approx(210));
  CHECK(material.poissons_ratio == doctest::Approx(0.3));
}



TEST_CASE("import: a deck of parts and instances is a complete scene")
{
  const auto [text, messages] = imported(test_mesh("cae-blocks.inp"));
  const Scene<2> scene        = checked<2>(text);
  REQUIRE(scene.bodies.size() == 2);
  CHECK(scene.model == "plane strain");
  CHECK(scene.bodies[1].name == "Block-2");
  CHECK(scene.bodies[1].material.youngs_modulus == 200000);
  CHECK(scene.bodies[1].material.poissons_ratio == 0.3);
  REQUIRE(scene.supports.size() == 2);
  CHECK(scene.supports[0].nodes.sets == std::vector<std::string>{"Block-1.side", "Block-2.side"});
  CHECK(scene.supports[0].displacement.text() == "0; free");
  REQUIRE(scene.loads.size() == 1);
  CHECK(scene.loads[0].boundaries == std::vector<std::string>{"Block-2.Block-2.Left"});
  CHECK(scene.loads[0].pressure.formula() == "100*t");
  REQUIRE(scene.pairs.size() == 1);
  CHECK(scene.pairs[0].slave == "Block-2.Block-2.Right");
  CHECK(scene.pairs[0].master == "Block-1.Block-1.Left");
  CHECK(scene.contact.method == "Lagrange multiplier");
  CHECK(scene.load_steps.ends() == std::vector<double>{1});
  // By logarithmic strain, as of Abaqus, which alone knows instances.
  CHECK(scene.deformation == Deformation::finite);
  CHECK(scene.bodies[1].material.law == "Hencky");
  CHECK(messages.find("NLGEOM") == std::string::npos);
}



TEST_CASE("import: pieces, forces on nodes, linear contact; what is left out is said")
{
  const auto [text, messages] = imported(test_mesh("pieces.inp"));
  const Scene<2> scene        = checked<2>(text);
  REQUIRE(scene.bodies.size() == 2);
  CHECK(scene.model == "plane stress");
  CHECK(scene.bodies[0].name == "piece1");
  CHECK(scene.bodies[0].degree == 2);
  CHECK(scene.contact.method == "Lagrange multiplier");
  REQUIRE(scene.loads.size() == 3);
  CHECK(scene.loads[0].force.text() == "0; -1.66666666667*t/2");
  CHECK(scene.loads[2].nodes.sets.size() == 1);
  CHECK(scene.load_steps.ends() == std::vector<double>{2});
  REQUIRE(scene.pairs.size() == 1);
  CHECK(scene.pairs[0].friction.mu.text == "0.2");
  CHECK(scene.pairs[0].compliance.normal_stiffness == 1e4);
  CHECK(scene.pairs[0].compliance.tangential_stiffness == 1e4);
}



TEST_CASE("import: relations of pressure and overclosure")
{
  const auto compliance = [](const std::string &behaviour, const std::string &says_so = "") {
    std::ifstream in(test_mesh("pieces.inp"));
    std::string   deck((std::istreambuf_iterator<char>(in)), {});
    const auto    at = deck.find("*SURFACE BEHAVIOR");
    deck.replace(at, deck.find("*FRICTION") - at, "*SURFACE BEHAVIOR, " + behaviour);
    const TemporaryFile file(deck, ".inp");
    const auto [text, messages] = imported(file.path);
    says(messages, says_so);
    return checked<2>(text).pairs[0].compliance;
  };
  const auto exponential = compliance("PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.02, 3.\n");
  CHECK(exponential.overclosure(3).value == doctest::Approx(0));
  CHECK(exponential.overclosure(300).value == doctest::Approx(0.02));
  CHECK(exponential.reach() == 0.02);
  const auto table =
    compliance("PRESSURE-OVERCLOSURE=TABULAR\n0., -0.2\n0., -0.1\n2., 0.1\n3., 0.15\n");
  CHECK(table.reach() == 0.1);
  CHECK(table.overclosure(1).value == doctest::Approx(0));
  CHECK(table.overclosure(4).value == doctest::Approx(0.2));
  CHECK(compliance("PRESSURE-OVERCLOSURE=TABULAR\n0., 0.\n2., 0.1\n2., 0.15\n",
                   "does not increase from zero, contact is hard")
          .kind == PressureOverclosure::hard);
  CHECK(compliance("PRESSURE-OVERCLOSURE=EXPONENTIAL, NO SEPARATION\n0.02, 3.\n",
                   "EXPONENTIAL with NO SEPARATION")
          .kind == PressureOverclosure::hard);
  CHECK(compliance("PRESSURE-OVERCLOSURE=TIED\n2e4\n").normal_stiffness == 2e4);
  CHECK_THROWS_AS(compliance("PRESSURE-OVERCLOSURE=LINEAR\n0.\n"), SceneError);
}



// Coefficients by pressure, and what has no counterpart.
TEST_CASE("import: kinds of friction")
{
  const auto with = [](const std::string &friction) {
    std::ifstream in(test_mesh("pieces.inp"));
    std::string   deck((std::istreambuf_iterator<char>(in)), {});
    const auto    at = deck.find("*FRICTION");
    deck.replace(at, deck.find("*CONTACT PAIR") - at, friction);
    return deck;
  };
  {
    const TemporaryFile file(with("*FRICTION\n0.25\n"), ".inp");
    const auto [text, messages] = imported(file.path);
    CHECK(checked<2>(text).pairs[0].friction.mu.text == "0.25");
    CHECK(messages.find("FRICTION") == std::string::npos);
  }
  {
    const TemporaryFile file(with("*FRICTION, TAUMAX=30.\n0.3, , 0.\n0.1, , 100.\n"), ".inp");
    const auto [text, messages] = imported(file.path);
    const auto mu               = checked<2>(text).pairs[0].friction;
    CHECK(mu.value({}, 0, 50, 0) == doctest::Approx(0.2));
    CHECK(mu.bound({}, 0, 50, 0) == doctest::Approx(10));
    CHECK(mu.bound({}, 0, 1000, 0) == doctest::Approx(30));
    CHECK(messages.find("FRICTION") == std::string::npos);
  }
  {
    // A table by pressure: the slip rate is the same in all lines.
    const TemporaryFile file(with("*FRICTION, DEPENDENCIES=0\n0.6, 2., 0.\n0.1, 2., 20.\n"),
                             ".inp");
    const auto [text, messages] = imported(file.path);
    const auto mu               = checked<2>(text).pairs[0].friction;
    CHECK(mu.value({}, 0, 10, 0) == doctest::Approx(0.35));
    CHECK(messages.find("FRICTION") == std::string::npos);
  }
  {
    const TemporaryFile file(with("*FRICTION\n0.6, 0., 0.\n0.1, 1., 0.\n"), ".inp");
    const auto [text, messages] = imported(file.path);
    CHECK(checked<2>(text).pairs[0].friction.mu.text == "0.6");
    says(messages, "not imported: pair: *FRICTION (its dependence on slip rate");
  }
  {
    const TemporaryFile file(with("*FRICTION\n0.3, , , 20.\n"), ".inp");
    const auto [text, messages] = imported(file.path);
    CHECK(checked<2>(text).pairs[0].friction.mu.text == "0.3");
    CHECK(messages.find("FRICTION") == std::string::npos);
  }
  {
    const TemporaryFile file(with("*FRICTION\n0.3\n0.1\n"), ".inp");
    CHECK_THROWS_AS(imported(file.path), SceneError);
  }
  for (const std::string kind : {"*FRICTION, USER\n", "*FRICTION, ANISOTROPIC\n0.3, 0.1\n"})
    {
      CAPTURE(kind);
      const TemporaryFile file(with(kind), ".inp");
      const auto [text, messages] = imported(file.path);
      CHECK(checked<2>(text).pairs[0].friction.is_zero());
      says(messages, "contact is without friction");
    }
  {
    const TemporaryFile file(with("*FRICTION, ROUGH\n"), ".inp");
    const auto [text, messages] = imported(file.path);
    CHECK(checked<2>(text).pairs[0].friction.mu.text == "1e6");
  }
  {
    const TemporaryFile file(with("*FRICTION, EXPONENTIAL DECAY\n0.3, 0.1, 2.\n"), ".inp");
    const auto [text, messages] = imported(file.path);
    CHECK(checked<2>(text).pairs[0].friction.mu.text == "0.3");
    says(messages, "the decay with the slip rate, the static coefficient counts");
  }
  const TemporaryFile file(with("*FRICTION\n-0.1\n"), ".inp");
  CHECK_THROWS_AS(imported(file.path), SceneError);
}



TEST_CASE("import: steps, amplitudes, gravity, pressures on elements, symmetry")
{
  const TemporaryFile file(
    "*INCLUDE, INPUT=" + std::filesystem::path(test_mesh("pieces.inp")).string() +
      "\n*AMPLITUDE, NAME=saw\n0, 0, 1, 1, 2, 0\n*MATERIAL, NAME=EL\n*DENSITY\n3.\n*STEP\n*STATIC\n"
      "1, 2\n*DLOAD, AMPLITUDE=saw\n1, P4, 5.\nEall, GRAV, 2., 0, -1, 0\n*END STEP\n"
      "*STEP, PERTURBATION\n*FREQUENCY\n3\n*END STEP\n*STEP\n*STATIC\n"
      "*DLOAD, OP=NEW\n1, P4, 7.\n*BOUNDARY\nNends, XSYMM\n*MODEL CHANGE, TYPE=ELEMENT, REMOVE\n"
      "*CLOAD, OP=NEW\nNends, 2, 1.\n*END STEP\n",
    ".inp");
  const auto [text, messages] = imported(file.path);
  const Scene<2> scene        = checked<2>(text);
  CHECK(scene.load_steps.ends() == std::vector<double>{2, 3, 4, 5});
  REQUIRE(scene.loads.size() == 5);
  CHECK(scene.loads[0].force.text().find("table(t, 0, 0, 2, -1.66") != std::string::npos);
  const Load<2> &pressure = scene.loads[3];
  CHECK(pressure.boundaries == std::vector<std::string>{"piece1.DLOAD 1"});
  for (const auto &[t, p] :
       std::vector<std::pair<double, double>>{{1, 0}, {3, 5}, {4, 0}, {4.5, 3.5}, {5, 7}})
    CHECK(std::abs(pressure.pressure.value({}, t) - p) < 1e-6);
  CHECK(std::abs(scene.loads[4].body_force.value({}, 3)[1] + 6) < 1e-6);
  CHECK(scene.loads[4].bodies == std::vector<std::string>{"piece1", "piece2"});
  CHECK(std::abs(scene.loads[0].force.value({}, 5)[1] - 1) < 1e-6);
  CHECK(std::abs(scene.loads[1].force.value({}, 5)[1]) < 1e-6);
  for (const std::string word : {"*MODEL CHANGE", "PERTURBATION", "*FREQUENCY"})
    says(messages, word);
}



namespace
{
  /// Two cells, one on the other, of density 0.5, held at the base; then what is given.
  Scene<3>
  column(const std::string &steps, std::string &scene_text)
  {
    const TemporaryFile file(
      "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n"
      "7, 1, 1, 1\n8, 0, 1, 1\n9, 0, 0, 2\n10, 1, 0, 2\n11, 1, 1, 2\n12, 0, 1, 2\n"
      "*ELEMENT, TYPE=C3D8, ELSET=all\n1, 1, 2, 3, 4, 5, 6, 7, 8\n2, 5, 6, 7, 8, 9, 10, 11, 12\n"
      "*NSET, NSET=base\n1, 2, 3, 4\n*NSET, NSET=top, GENERATE\n9, 12\n*ELSET, ELSET=up\n2\n"
      "*NSET, NSET=press\n5, 6, 9, 10\n*SURFACE, NAME=PRESS\n2, S2\n*SURFACE, NAME=press2\n2, S3\n"
      "*AMPLITUDE, NAME=wave\n0, 0, 0.5, 2, 1, 1\n"
      "*AMPLITUDE, NAME=total, TIME=TOTAL TIME\n0, 0, 1, 1, 3, 5\n"
      "*MATERIAL, NAME=M\n*ELASTIC\n1000, 0.3\n*DENSITY\n0.5\n"
      "*SOLID SECTION, ELSET=all, MATERIAL=M\n*BOUNDARY\nbase, 1, 3\n" +
        steps,
      ".inp");
    scene_text = imported(file.path).first;
    return checked<3>(scene_text);
  }

  /// All forces along z at time t.
  double
  force_at(const Scene<3> &scene, const double t)
  {
    const auto &generator = *scene.bodies[0].mesh.generator;
    const auto  in_body   = [](const std::string &name) { return name.substr(name.find('.') + 1); };
    double      result    = 0;
    for (const auto &load : scene.loads)
      {
        for (const std::string &set : load.nodes.sets)
          result += generator.node_set(in_body(set)).nodes.size() * load.force.value({}, t)[2];
        for (const std::string &body : load.bodies)
          result += (body == scene.bodies[0].name ? 2 : generator.cell_set(in_body(body)).size()) *
                    load.body_force.value({}, t)[2];
        result -= load.boundaries.size() * load.pressure.value({}, t); // faces of size 1
      }
    return result;
  }

  std::string
  step(const std::string &text, const std::string &parameters = "")
  {
    return "*STEP" + parameters + "\n*STATIC\n1, 1\n" + text + "*END STEP\n";
  }
} // namespace



// The values are those of CalculiX 2.20.
TEST_CASE("import: what a later step says of a place replaces, whatever names it; one step adds up")
{
  const auto check = [](const std::string                            &steps,
                        const std::vector<std::pair<double, double>> &forces) {
    std::string    text;
    const Scene<3> scene = column(steps, text);
    for (const auto &[t, force] : forces)
      {
        CAPTURE(text);
        CHECK(std::abs(force_at(scene, t) - force) < 1e-6);
      }
    CHECK(text.find("Not imported") == std::string::npos);
  };
  check(step("*CLOAD\ntop, 3, -10\n") + step("*CLOAD\n9, 3, -50\n"), {{1, -40}, {2, -80}});
  check(step("*CLOAD\ntop, 3, -1\n9, 3, -2\n*CLOAD\n9, 3, -4\n"), {{0.5, -5}, {1, -10}});
  check(step("*CLOAD\ntop, 3, -1\n") + step("*CLOAD, OP=NEW\n9, 3, -5\n"),
        {{1, -4}, {1.5, -3}, {2, -5}});
  check(step("*CLOAD\ntop, 3, -1\n") + step("*CLOAD\n9, 3, -5\n*CLOAD, OP=NEW\n5, 3, -7\n"),
        {{1, -4}, {2, -15}});
  // What an amplitude has come to stays in later steps, if it does not count the total time.
  check(step("*CLOAD, AMPLITUDE=wave\n9, 3, -1\n") + step("*CLOAD\n10, 3, -5\n"),
        {{0.5, -2}, {1, -1}, {1.5, -3.5}, {2, -6}});
  check(step("*CLOAD, AMPLITUDE=total\n9, 3, -1\n") + step("") + step("*CLOAD\n9, 3, -1\n"),
        {{1, -1}, {1.5, -2}, {2, -3}, {3, -1}});
  check(step("*CLOAD\n9, 3, -2\n", ", AMPLITUDE=STEP"), {{0.5, -2}, {1, -2}});
  check(step("*DLOAD\n2, P2, 1\n") + step("*DLOAD\nup, P2, 5\n"), {{2, -5}});
  check(step("*DLOAD\n2, P2, 1\nup, P2, 1\n"), {{1, -2}});
  check(step("*DSLOAD\nPRESS, P, 1\n") + step("*DLOAD\n2, P2, 5\n"), {{1, -1}, {2, -5}});
  // Gravity replaces that of the same name and direction, and no other.
  const std::string down = ", 0, 0, -1\n";
  check(step("*DLOAD\nall, GRAV, 1" + down) + step("*DLOAD\nall, GRAV, 3" + down),
        {{1, -1}, {2, -3}});
  check(step("*DLOAD\nall, GRAV, 1" + down) + step("*DLOAD\nup, GRAV, 3" + down), {{2, -2.5}});
  check(step("*DLOAD\nup, GRAV, 3" + down) + step("*DLOAD, OP=NEW\nall, BZ, 2\n"),
        {{1, -1.5}, {2, 4}});
  check(step("*DLOAD\nall, BZ, 1\n") + step("*DLOAD\nup, BZ, 3\n"), {{1, 2}, {2, 4}});
}



TEST_CASE("import: pressures on faces between elements are left out, and the others act")
{
  std::string    text;
  const Scene<3> scene = column(step("*DLOAD\nall, P2, 3\n"), text);
  says(text, "load: pressures on 1 faces inside of bodies");
  CHECK(std::abs(force_at(scene, 1) + 3) < 1e-12);
}



TEST_CASE("import: a surface and a set of nodes may have one name")
{
  std::string    text;
  const Scene<3> scene = column(step("*BOUNDARY\npress, 1, 2\n*DSLOAD\npress, P, 3\n"), text);
  REQUIRE(scene.loads.size() == 1);
  CHECK(scene.loads[0].boundaries == std::vector<std::string>{scene.bodies[0].name + ".PRESS"});
  REQUIRE(scene.supports.size() == 2);
  CHECK(scene.supports[1].nodes.sets == std::vector<std::string>{scene.bodies[0].name + ".press"});
}



TEST_CASE("import: load steps end where amplitudes bend")
{
  std::string text;
  CHECK(column(step("*CLOAD, AMPLITUDE=wave\n9, 3, -1\n") + step(""), text).load_steps.ends() ==
        std::vector<double>{0.5, 1, 2});
}



TEST_CASE("import: supports of later steps replace, begin and end")
{
  std::string text;
  {
    const Scene<3> scene =
      column(step("*BOUNDARY\ntop, 3, 3, -0.1\n") + step("*BOUNDARY\n9, 3, 3, -0.2\n") +
               step("*BOUNDARY, OP=NEW\nbase, 1, 3\n") +
               step("*BOUNDARY, TYPE=VELOCITY\n9, 3, 3, -0.5\n"),
             text);
    const auto held = [&](const double t) {
      double sum = 0;
      for (const auto &support : scene.supports)
        if (support.acts(t) && !support.displacement.prescribed(0))
          for (const std::string &set : support.nodes.sets)
            sum +=
              scene.bodies[0].mesh.generator->node_set(set.substr(set.find('.') + 1)).nodes.size() *
              support.displacement.value({}, t)[2];
      return sum;
    };
    for (const auto &[t, sum] :
         std::vector<std::pair<double, double>>{{1, -0.4}, {2, -0.5}, {3, 0}, {4, -0.5}})
      CHECK(std::abs(held(t) - sum) < 1e-6);
    CHECK(scene.load_steps.ends() == std::vector<double>{1, 2, 3, 4});
  }
  // The support of the model is removed too.
  const Scene<3> scene = column(step("*BOUNDARY, OP=NEW\n1, 1, 3\n2, 2, 3\n4, 3, 3\n"), text);
  unsigned int   n     = 0;
  for (const auto &support : scene.supports)
    for (unsigned int d = 0; d < 3; ++d)
      if (support.acts(1) && support.displacement.prescribed(d))
        for (const std::string &set : support.nodes.sets)
          n += scene.bodies[0].mesh.generator->node_set(set.substr(set.find('.') + 1)).nodes.size();
  CHECK(n == 3 + 2 + 1);
}



TEST_CASE("import: loads without a type, and components that are none, are left out")
{
  const TemporaryFile file("*INCLUDE, INPUT=" +
                             std::filesystem::path(test_mesh("pieces.inp")).string() +
                             "\n*STEP\n*STATIC\n1, 1\n*DLOAD\nEall,\n*BOUNDARY\nNends, 1e300\n"
                             "*CLOAD\nNends, 1e300, 2\n*END STEP\n",
                           ".inp");
  const std::string   messages = imported(file.path).second;
  says(messages, "*DLOAD (type )");
  says(messages, "*CLOAD of moments and fluxes");
}



TEST_CASE("import: temperatures of a body; what may have held bodies")
{
  const auto deck = [](const std::string &temperatures) {
    return "*INCLUDE, INPUT=" + std::filesystem::path(test_mesh("pieces.inp")).string() +
           "\n*MATERIAL, NAME=EL\n*EXPANSION\n2.e-5\n"
           "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 20.\n" +
           temperatures;
  };
  // The deck's own step ends at t = 2, the two of these at 3 and 4.
  {
    const TemporaryFile file(deck("*STEP\n*STATIC\n*TEMPERATURE\nNall, 120.\n*END STEP\n"
                                  "*STEP\n*STATIC\n*TEMPERATURE\nNall, 70.\n*END STEP\n"),
                             ".inp");
    const auto [text, messages] = imported(file.path);
    const Scene<2> scene        = checked<2>(text);
    for (const auto &body : scene.bodies)
      {
        CHECK(body.expansion.given());
        CHECK(body.expansion.reference == 20);
        for (const auto &[t, T] : std::vector<std::pair<double, double>>{
               {0, 20}, {2, 20}, {2.5, 70}, {3, 120}, {3.5, 95}, {4, 70}})
          CHECK(std::abs(body.expansion.value({}, t, 0) - T) < 1e-6);
      }
    CHECK(messages.find("TEMPERATURE") == std::string::npos);
    CHECK(messages.find("EXPANSION") == std::string::npos);
  }
  {
    const TemporaryFile file(deck("*STEP\n*STATIC\n*TEMPERATURE\nNends, 120.\n*END STEP\n"),
                             ".inp");
    const auto [text, messages] = imported(file.path);
    says(messages, "temperatures that differ from node to node of piece2");
    CHECK(!checked<2>(text).bodies[1].expansion.given());
  }
  {
    // What an amplitude has come to stays; OP=NEW goes back to the initial temperature.
    const TemporaryFile file(
      deck("*AMPLITUDE, NAME=up\n0., 1., 1., 3.\n*STEP\n*STATIC\n1., 1.\n"
           "*TEMPERATURE, AMPLITUDE=up\nNall, 30.\n*END STEP\n*STEP\n*STATIC\n.5, .5\n*END STEP\n"
           "*STEP\n*STATIC\n1., 1.\n*TEMPERATURE, OP=NEW\n*END STEP\n"),
      ".inp");
    const auto [text, messages] = imported(file.path);
    const Scene<2> scene        = checked<2>(text);
    says(messages, "CalculiX begins the amplitude of temperatures anew");
    for (const auto &[t, T] :
         std::vector<std::pair<double, double>>{{3, 90}, {3.5, 90}, {4, 55}, {4.5, 20}})
      CHECK(std::abs(scene.bodies[0].expansion.value({}, t, 0) - T) < 1e-6);
  }
  {
    // Bodies with amplitudes of their own, in one step.
    const TemporaryFile file(
      deck("*AMPLITUDE, NAME=half\n0., 0., 1., .5\n*STEP\n*STATIC\n1., 1.\n"
           "*TEMPERATURE, AMPLITUDE=half\nNall, 40.\n*TEMPERATURE\nNall, 40.\n*END STEP\n"),
      ".inp");
    CHECK(checked<2>(imported(file.path).first).bodies[0].expansion.value({}, 3, 0) ==
          doctest::Approx(40));
  }
  CHECK(checked<2>(imported(test_mesh("cae-blocks.inp")).first).newton.undetermined_modes ==
        UnconstrainedModeTreatment::hold);
}



TEST_CASE("import: what leaves nothing to solve is refused")
{
  const auto attempt = [](const std::string &text) {
    const TemporaryFile file(text, ".inp");
    return message_of([&] { imported(file.path); });
  };
  says(attempt("*NODE\n1, 0, 0\n2, 1, 0\n*ELEMENT, TYPE=B31\n1, 1, 2\n"),
       "no elastic solid is left");
  says(attempt(cube), "no elements have a *SOLID SECTION");
  says(attempt(cube + "*ELSET, ELSET=e\n1\n*MATERIAL, NAME=m\n*HYPERELASTIC\n1, 2\n"
                      "*SOLID SECTION, ELSET=e, MATERIAL=m\n"),
       "is not elastic: it has neither *ELASTIC nor one of the *HYPERELASTIC");
  const std::string square =
    "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 3, 0\n6, 4, 0\n7, 4, 1\n"
    "8, 3, 1\n*ELEMENT, TYPE=CPE4, ELSET=a\n1, 1, 2, 3, 4\n";
  says(
    attempt(square + "*ELEMENT, TYPE=CPS4, ELSET=a\n2, 5, 6, 7, 8\n"),
    "has elements of plane strain (CPE4) and of plane stress (CPS4); a scene has one Model for all "
    "bodies. Give all elements one of these types");
  says(attempt(
         square + "*NODE\n9, 2, 0\n10, 2, 1\n*ELEMENT, TYPE=CPE4, ELSET=b\n2, 2, 9, 10, 3\n" +
         of_cube +
         "*SOLID SECTION, ELSET=a, MATERIAL=m\n0.5\n*SOLID SECTION, ELSET=b, MATERIAL=m\n1\n"),
       "elements 1 and 2 are connected and have different thicknesses");
  const std::string solid =
    cube + "*ELSET, ELSET=e\n1\n" + of_cube + "*SOLID SECTION, ELSET=e, MATERIAL=m\n";
  says(attempt(solid + "*MATERIAL, NAME=M\n*ELASTIC\n1, 0\n"), "the material 'M' is there twice");
  says(attempt(solid +
               "*BOUNDARY\n1, 1, 2\n*NSET, NSET=n\n1, 2\n*TRANSFORM, NSET=n\n0,1,0,1,0,0\n"),
       "*TRANSFORM of nodes that have *BOUNDARY or *CLOAD above");
  says(attempt(solid + "*NSET, NSET=5\n1, 2\n*BOUNDARY\n5, 1\n"),
       "a set of nodes is called as a number: 5");
  says(attempt(solid + "*CLOAD\n, 1, 1.\n"), "*CLOAD without the name of a node or set");
  for (const std::string range : {"1, 8, 2", "8, 1", "1, 8, 0"})
    says(attempt(solid + "*NSET, NSET=n, GENERATE\n" + range + "\n"), "GENERATE: steps of ");
}



namespace
{
  std::string
  second_cube(const unsigned int number, const std::string &z)
  {
    std::string text = "*NODE\n";
    const char *xy[] = {"0, 0, ", "1, 0, ", "1, 1, ", "0, 1, "};
    for (unsigned int i = 0; i < 8; ++i)
      text += std::to_string(11 + i) + ", " + xy[i % 4] + (i < 4 ? z : "9") + "\n";
    return text + "*ELEMENT, TYPE=C3D8, ELSET=second\n" + std::to_string(number) +
           ", 11, 12, 13, 14, 15, 16, 17, 18\n";
  }
} // namespace



TEST_CASE("keywords: data lines of other files, quotes, no blanks, numbers by name")
{
  const TemporaryFile more("1, 2\n", ".more");
  const auto          name_of = [](const TemporaryFile &file) {
    return std::filesystem::path(file.path).filename().string();
  };
  const TemporaryFile numbers("5, 0, 0, <top>\n6, 1, 0, <top>\n", ".numbers");
  const TemporaryFile file(
    "*PARAMETER\nhalf = 1.5  # a comment\ntop = half*2**2 - 4\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n"
    "3, 1, 1, 0\n4, 0, 1, 0\n*INCLUDE, INPUT=" +
      name_of(numbers) +
      "\n7, 1, 1, <top>\n8, 0, 1, <top>\n"
      "*SURFACE, NAME=\"late, but here\"\n\"the cell\", S2\n*NSET, NSET=\"two nodes\"\n*INCLUDE, "
      "INPUT=" +
      name_of(more) +
      "\n77, nobody\n*NSET, NSET=four\n\"two nodes\", later\n*NSET, NSET=later\n3, 4\n"
      "*ELEMENT, TYPE=C3D8, ELSET=\"the cell\"\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
      "*SOLIDSECTION, ELSET=\"the cell\", MATERIAL=m\n*MATERIAL, NAME=m\n1, 2\n*ELASTIC\n100*2, 0.3\n",
    ".inp");
  const MeshFile mesh = read_abaqus(file.path);
  CHECK(mesh.nodes[4].distance(Point<3>(0, 0, 2)) < 1e-14);
  CHECK(group(mesh, "two nodes").nodes == MeshFile::Nodes{0, 1});
  CHECK(group(mesh, "four").nodes == MeshFile::Nodes{0, 1, 2, 3});
  CHECK(group(mesh, "late, but here").faces.size() == 1);
  REQUIRE(mesh.notes.size() == 2);
  says(mesh.notes[0], "node set two nodes: there is no '77'");
  says(mesh.notes[1], "there is no 'nobody'");
  says(message_of([&] { imported(file.path); }), "'100*2' should be a number");

  const auto attempt = [](const std::string &text) {
    const TemporaryFile one(text, ".inp");
    return message_of([&] { read_abaqus(one.path); });
  };
  says(attempt("*PARAMETER, DEPENDENT\na = 1\n" + cube), "*PARAMETER, DEPENDENT is not read here");
  says(attempt("*PARAMETER\na = b + 1\n" + cube), "*PARAMETER: 'a = b + 1' ");
  says(attempt("*SURFACE, NAME=s\ne, S1\n" + cube), "line 2: 'e' is no element or set");
}



TEST_CASE("import: what acts and is left out is of a kind; a body without section; hyperelasticity")
{
  const TemporaryFile file(
    "stray\n" + cube + second_cube(2, "5") +
      "*ELSET, ELSET=e\n1\n*ELEMENT, TYPE=CPS4, ELSET=sheet\n9, 1, 2, 3, 4\n"
      "*NODE, NSET=far\n99, 5, 5, 5\n*RIGID BODY, NSET=far, REF NODE=99\n"
      "*SURFACE, NAME=s\ne, S2\n*SURFACE, NAME=t\nsecond, S1\n"
      "*MATERIAL, NAME=m\n*HYPERELASTIC, NEO HOOKE\n0.5, 0.1\n*SOLID SECTION, ELSET=e, MATERIAL=m\n"
      "*SOLID SECTION, ELSET=sheet, MATERIAL=m\n0.5\n*PLASTIC\n1\n"
      "*CONTACT PAIR, INTERACTION=i\ns, t\n*WHATEVER\n1\n*STEP, NLGEOM\n*STATIC\n*BOUNDARY\n"
      "far, 1, 2\nfar, 3, 3, 0.1\n*END STEP\n",
    ".inp");
  const Scene<3> scene = checked<3>(imported(file.path).first);
  REQUIRE(scene.bodies.size() == 1);
  for (const std::string what : {"body: second (1 cell",
                                 "body: 1 elements of type CPS4",
                                 "support: *RIGID BODY",
                                 "material: *PLASTIC",
                                 "pair: the master of a contact pair on 't'",
                                 "keyword: *WHATEVER",
                                 "keyword: data lines before the first keyword",
                                 "motion: *BOUNDARY at 1 nodes of far"})
    says(scene.skipped_items, what);
  // mu = 2 C10 = 1, K = 2/D1 = 20.
  const Material &rubber = scene.bodies[0].material;
  CHECK(rubber.law == "polynomial");
  CHECK(rubber.coefficients == std::vector<double>{0.5, 0, 0, 0});
  CHECK(rubber.mu() == doctest::Approx(1));
  CHECK(rubber.bulk_modulus() == doctest::Approx(20));
  CHECK(scene.deformation == Deformation::finite);
}



TEST_CASE("import: coefficients of hyperelastic materials")
{
  struct Case
  {
    std::string         card, law;
    std::vector<double> coefficients;
    double              mu, K;
  };
  // K = 2/D1, and 20 mu where D1 = 0.
  for (const Case &one : std::vector<Case>{
         {"MOONEY-RIVLIN\n0.3, 0.2, 0.1", "polynomial", {0.3, 0.2, 0, 0}, 1, 20},
         {"YEOH\n0.5, -0.1, 0.01, 0.1, 0, 0", "polynomial", {0.5, 0, -0.1, 0.01}, 1, 20},
         {"REDUCED POLYNOMIAL, N=2\n0.5, 0.2, 0.1, 0", "polynomial", {0.5, 0, 0.2, 0}, 1, 20},
         {"POLYNOMIAL, N=1\n0.3, 0.7, 0.", "polynomial", {0.3, 0.7, 0, 0}, 2, 40},
         {"OGDEN, N=2\n0.6, 2, 0.4, -2, 0.1, 0", "Ogden", {0.6, 2, -0.4, -2}, 1, 20}})
    {
      CAPTURE(one.card);
      const TemporaryFile file(cube + "*ELSET, ELSET=e\n1\n*MATERIAL, NAME=m\n*HYPERELASTIC, " +
                                 one.card + "\n*SOLID SECTION, ELSET=e, MATERIAL=m\n",
                               ".inp");
      const Material      material = checked<3>(imported(file.path).first).bodies[0].material;
      CHECK(material.law == one.law);
      REQUIRE(material.coefficients.size() == one.coefficients.size());
      for (unsigned int i = 0; i < one.coefficients.size(); ++i)
        CHECK(material.coefficients[i] == doctest::Approx(one.coefficients[i]));
      CHECK(material.mu() == doctest::Approx(one.mu));
      CHECK(material.bulk_modulus() == doctest::Approx(one.K));
    }
}



TEST_CASE("import: ADJUST, CLEARANCE, several materials of a connected body")
{
  const std::string   gaps = "*SURFACE, NAME=s\ne, S2\n*SURFACE, NAME=t\nsecond, S1\n";
  const TemporaryFile file(
    cube + second_cube(2, "1.01") + "*ELSET, ELSET=e\n1\n" + gaps + of_cube +
      "*MATERIAL, NAME=soft\n*ELASTIC\n2, 0.1\n*SOLID SECTION, ELSET=e, MATERIAL=m\n"
      "*SOLID SECTION, ELSET=second, MATERIAL=m\n*NODE\n21, 0, 0, 11\n22, 1, 0, 11\n23, 1, 1, 11\n"
      "24, 0, 1, 11\n*ELEMENT, TYPE=C3D8, ELSET=third\n3, 15, 16, 17, 18, 21, 22, 23, 24\n"
      "*SOLID SECTION, ELSET=third, MATERIAL=soft\n*CONTACT PAIR, INTERACTION=i, ADJUST=0.02\nt, s\n",
    ".inp");
  const Scene<3> scene = checked<3>(imported(file.path).first);
  CHECK(imported(file.path).first.find("set Curved boundaries = none") != std::string::npos);
  REQUIRE(scene.bodies.size() == 2);
  REQUIRE(scene.bodies[1].others.size() == 1);
  CHECK(scene.bodies[1].others[0].cells == "third");
  CHECK(scene.bodies[1].others[0].material.youngs_modulus == 2);
  const Mesh<3> mesh({{"a", scene.bodies[0].mesh}, {"b", scene.bodies[1].mesh}},
                     {},
                     {},
                     MPI_COMM_WORLD);
  CHECK(mesh.n_materials() == 3);
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const double z = cell->center()[2];
        CHECK(cell->material_id() == (z < 1 ? 0 : z < 9 ? 1 : 2));
        CHECK(mesh.body(cell) == (z < 1 ? 0 : 1));
      }

  const TemporaryFile clear(cube + second_cube(2, "1.01") + "*ELSET, ELSET=e\n1\n" + gaps +
                              of_cube +
                              "*SOLID SECTION, ELSET=e, MATERIAL=m\n"
                              "*SOLID SECTION, ELSET=second, MATERIAL=m\n"
                              "*CONTACT PAIR, INTERACTION=i\nt, s\n"
                              "*CLEARANCE, MASTER=S, SLAVE=T, VALUE=0.25\n",
                            ".inp");
  CHECK(checked<3>(imported(clear.path).first).pairs.at(0).initial_gap.text == "0.25");
}



TEST_CASE("ADJUST moves nodes of the slave onto the master")
{
  // The lower nodes of the second cube, 11 to 14, are those of t.
  const auto heights = [](const std::string &z, const std::string &adjust) {
    const TemporaryFile file(cube + second_cube(2, z) +
                               "*NSET, NSET=two\n11, 13, 18\n*SURFACE, NAME=s\n1, S2\n"
                               "*SURFACE, NAME=t\n2, S1\n*CONTACT PAIR, INTERACTION=i, ADJUST=" +
                               adjust + "\nt, s\n",
                             ".inp");
    const MeshFile      mesh = read_abaqus(file.path);
    std::vector<double> result;
    for (unsigned int i = 8; i < 12; ++i)
      result.push_back(mesh.nodes[i][2]);
    CHECK(mesh.nodes[15][2] == 9);
    return result;
  };
  using Heights = std::vector<double>;
  CHECK(heights("1.01", "0.02") == Heights{1, 1, 1, 1});
  CHECK(heights("1.01", "0.005") == Heights{1.01, 1.01, 1.01, 1.01});
  CHECK(heights("0.99", "0.") == Heights{1, 1, 1, 1});
  CHECK(heights("1.01", "two") == Heights{1, 1.01, 1, 1.01});
  // One is beside the master.
  const TemporaryFile plane(
    "*NODE\n1, 0, 0\n2, 2, 0\n3, 2, 1\n4, 0, 1\n5, 1, 1.5\n6, 3, 1.1\n7, 3, 2\n8, 1, 2\n9, 2, 1.3\n"
    "10, 3, 1.6\n11, 2, 2\n12, 1, 1.7\n*ELEMENT, TYPE=CPE4\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=CPE8\n"
    "2, 5, 6, 7, 8, 9, 10, 11, 12\n*SURFACE, NAME=s\n1, S3\n*SURFACE, NAME=t\n2, S1\n"
    "*CONTACT PAIR, INTERACTION=i, ADJUST=1.\nt, s\n",
    ".inp");
  const MeshFile mesh = read_abaqus(plane.path);
  CHECK(mesh.nodes[4].distance(Point<3>(1, 1, 0)) < 1e-14);
  CHECK(mesh.nodes[5].distance(Point<3>(3, 1.1, 0)) < 1e-14);
  CHECK(mesh.nodes[8].distance(Point<3>(2, 1, 0)) < 1e-14);
  CHECK(mesh.nodes[11].distance(Point<3>(1, 1.7, 0)) < 1e-14);
  REQUIRE(mesh.notes.size() == 1);
  says(mesh.notes[0], "2 nodes of t are moved onto s, by at most 0.5");
}



TEST_CASE("faces of collapsed elements have each corner once, or are none")
{
  // A cube, and beside it a wedge that is written as a hexahedron.
  const TemporaryFile deck(
    "*NODE\n9, 2, 0, 0\n10, 2, 0, 1\n" + cube +
      "*ELEMENT, TYPE=C3D8\n2, 2, 9, 3, 3, 6, 10, 7, 7\n*ELSET, ELSET=e\n1, 2\n" + of_cube +
      "*SOLID SECTION, ELSET=e, MATERIAL=m\n*STEP\n*STATIC\n*DLOAD\n2, P2, 1.\n"
      "2, P5, 3.\n*END STEP\n",
    ".inp");
  CHECK(group(read_abaqus(deck.path), "DLOAD 1").faces.at(0).size() == 3);
  const auto [text, messages] = imported(deck.path);
  says(messages, "surface DLOAD 1 2: elements of type C3D8 have no face S5");
  REQUIRE(checked<3>(text).loads.size() == 1);
  const auto body = generator<3>("file", {{"File", deck.path}})->generate();
  CHECK(std::find(body.boundaries.begin(), body.boundaries.end(), "DLOAD 1") !=
        body.boundaries.end());
}



TEST_CASE("import: what was lost in silence is told")
{
  const std::string head = "*STEP\n*STATIC\n1., 1.\n", tail = "*END STEP\n",
                    load = "*CLOAD\n5, 3, 1.\n";
  const std::vector<std::pair<std::string, std::string>> decks{
    {head + load + tail + "*STEP, PERTURBATION\n*STATIC\n*CLOAD\n6, 1, 1.\n" + tail,
     "load: *CLOAD (in a step that is left out)"},
    {"*STEP\n*STATIC, RIKS\n" + load + tail, "load: *STATIC (its RIKS)"},
    {head + load + tail + "*STEP, NLGEOM\n*STATIC\n" + load + tail,
     "model: *STEP (that strains are small in the steps before NLGEOM"},
    {"*NSET, NSET=n\n5, 5, 6\n" + head + "*CLOAD\nn, 3, 1.\n" + tail,
     "load: *CLOAD (on n, which names members twice"},
    {"*NSET, NSET=n\n5, nobody\n" + head + "*CLOAD\nn, 3, 1.\n" + tail,
     "keyword: node set n: there is no 'nobody'"},
    {head + load + "*BOUNDARY\n1, 11, 11, 40.\n" + tail,
     "support: *BOUNDARY (of temperatures, fluxes and the like)"},
    {head + load + "*BOUNDARY\n5, 3, 1, 0.1\n" + tail,
     "support: *BOUNDARY (whose last component is below the first)"},
    {"*CONTACT PAIR, INTERACTION=nothing\ns, s\n" + head + load + tail,
     "pair: *SURFACE INTERACTION NOTHING, which is not there"}};
  for (const auto &[what, told] : decks)
    {
      CAPTURE(told);
      const TemporaryFile file(cube + "*ELSET, ELSET=e\n1\n*SURFACE, NAME=s\ne, S2\n" + of_cube +
                                 "*SOLID SECTION, ELSET=e, MATERIAL=m\n*BOUNDARY\n1, 1, 3\n" + what,
                               ".inp");
      says(imported(file.path).second, told);
    }
  // All elements, and a number before a set of the same name.
  const TemporaryFile file(cube + second_cube(2, "5") +
                             "*ELSET, ELSET=2\n1\n*ELSET, ELSET=e\n1, 2\n" + of_cube +
                             "*DENSITY\n2\n*SOLID SECTION, ELSET=e, MATERIAL=m\n" + head +
                             "*DLOAD\n, GRAV, 3., 0, 0, -1\n2, BX, 1.\n" + tail,
                           ".inp");
  const Scene<3>      scene = checked<3>(imported(file.path).first);
  REQUIRE(scene.loads.size() == 2);
  CHECK(scene.loads[0].bodies == std::vector<std::string>{"second"});
  CHECK(scene.loads[1].bodies.size() == 2);
}



TEST_CASE("import: ties")
{
  const auto with = [](const std::string &keyword) {
    std::ifstream in(test_mesh("pieces.inp"));
    std::string   deck((std::istreambuf_iterator<char>(in)), {});
    const auto    at = deck.find("*CONTACT PAIR");
    deck.replace(at, deck.find("\n", at) - at, keyword);
    return deck;
  };
  for (const std::string keyword : {"*TIE, NAME=glue, POSITION TOLERANCE=0.25",
                                    "*TIE, ADJUST=NO",
                                    "*CONTACT PAIR, INTERACTION=hard, TIED"})
    {
      CAPTURE(keyword);
      const TemporaryFile file(with(keyword), ".inp");
      const auto [text, messages] = imported(file.path);
      const Scene<2> scene        = checked<2>(text);
      REQUIRE(scene.pairs.size() == 1);
      CHECK(scene.pairs[0].is_tied);
      CHECK(scene.pairs[0].search_distance ==
            (keyword.find("0.25") != std::string::npos ? 0.25 : 0.));
      CHECK(scene.pairs[0].friction.is_zero());
      CHECK(messages.find("TIE") == std::string::npos);
    }
  const TemporaryFile file(with("*TIE, CYCLIC SYMMETRY"), ".inp");
  const auto [text, messages] = imported(file.path);
  says(messages, "CYCLIC SYMMETRY");
  CHECK(text.find("subsection Contact pairs") == std::string::npos);
}



// A plate of R3D4 on the top of a cube, whose corners go around anticlockwise as seen from above.
TEST_CASE("import: rigid bodies of surface elements are obstacles")
{
  const auto deck = [](const std::string &side, const std::string &acts) {
    return cube +
           "*NODE\n9, 0.5, 0.5, 3.\n11, -1, -1, 1\n12, 2, -1, 1\n13, 2, 2, 1\n14, -1, 2, 1\n" +
           "*ELEMENT, TYPE=R3D4, ELSET=plate\n7, 11, 12, 13, 14\n*ELSET, ELSET=e\n1\n" +
           "*SURFACE, NAME=top\n1, S2\n*SURFACE, NAME=tool\nplate, " + side +
           "\n*RIGID BODY, ELSET=plate, REF NODE=9\n" + of_cube +
           "*SOLID SECTION, ELSET=e, MATERIAL=m\n*SURFACE INTERACTION, NAME=i\n" +
           "*CONTACT PAIR, INTERACTION=i\ntop, tool\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n4, 1, 3\n" +
           "9, 1, 2\n9, 4, 6\n*STEP\n*STATIC\n1., 1.\n" + acts + "*END STEP\n";
  };
  for (const auto &[side, sign] : {std::make_pair("SNEG", -1.), std::make_pair("SPOS", 1.)})
    {
      const TemporaryFile file(deck(side, "*BOUNDARY\n9, 3, 3, -0.01\n"), ".inp");
      const auto [text, messages] = imported(file.path);
      const Scene<3> scene        = checked<3>(text);
      CHECK(messages.empty());
      REQUIRE(scene.pairs.size() == 1);
      CHECK(scene.pairs[0].master == "tool");
      REQUIRE(scene.obstacles.size() == 1);
      const Obstacle<3> &tool = scene.obstacles[0];
      CHECK(tool.body.displacement.value({}, 0.5)[2] == doctest::Approx(-0.005));
      CHECK_FALSE(tool.body.is_free(2));
      CHECK(tool.shape->closest(Point<3>(0.5, 0.5, 0.8)).gap == doctest::Approx(-0.2 * sign));
    }
  const TemporaryFile file(deck("SNEG", "*CLOAD\n9, 3, -4.\n"), ".inp");
  const Scene<3>      scene = checked<3>(imported(file.path).first);
  CHECK(scene.obstacles.at(0).body.is_free(2));
  CHECK(scene.obstacles.at(0).body.force.value({}, 0.5)[2] == doctest::Approx(-2));
}



// The bottom of a punch about the axis x = y = 0.5, on the top of a cube: from its rim to the axis,
// so that outside is below. In the plane a die with a fillet.
TEST_CASE("import: analytical surfaces of lines and arcs are obstacles")
{
  const auto deck = [](const std::string &surface) {
    return cube + "*NODE\n9, 0.5, 0.5, 3.\n*ELSET, ELSET=e\n1\n*SURFACE, NAME=top\n1, S2\n" +
           surface + "*RIGID BODY, ANALYTICAL SURFACE=tool, REF NODE=9\n" + of_cube +
           "*SOLID SECTION, ELSET=e, MATERIAL=m\n*SURFACE INTERACTION, NAME=i\n" +
           "*CONTACT PAIR, INTERACTION=i\ntop, tool\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n4, 1, 3\n" +
           "9, 1, 2\n9, 4, 6\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n9, 3, 3, -0.01\n*END STEP\n";
  };
  const TemporaryFile file(deck("*SURFACE, TYPE=REVOLUTION, NAME=TOOL\n0.5, 0.5, 1, 0.5, 0.5, 2\n"
                                "START, 3., 1.\nCIRCL, 2., 0., 2., 1.\nLINE, 0., 0.\n"),
                           ".inp");
  const auto [text, messages] = imported(file.path);
  const Scene<3> scene        = checked<3>(text);
  CHECK(messages.empty());
  REQUIRE(scene.obstacles.size() == 1);
  CHECK(scene.pairs.at(0).master == scene.obstacles[0].name);
  CHECK(scene.obstacles[0].body.displacement.value({}, 1)[2] == doctest::Approx(-0.01));
  const auto gap = [&](const Point<3> &x) { return scene.obstacles[0].shape->closest(x).gap; };
  CHECK(gap(Point<3>(0.5, 0.5, 0.8)) == doctest::Approx(0.2));
  CHECK(gap(Point<3>(-0.5, 0.5, 1.3)) == doctest::Approx(-0.3));
  CHECK(gap(Point<3>(0.5, 3.3, 1.4)) == doctest::Approx(0));
  // What is not clear, or not known, is left out.
  for (const std::string other :
       {"*SURFACE, TYPE=CYLINDER, NAME=TOOL\nSTART, -1., 2.\nLINE, 5., 2.\n",
        "*SURFACE, TYPE=REVOLUTION, NAME=TOOL\n0, 0, 0, 0, 0, 1\nSTART, 0., "
        "1.\nPARAB, 1., 2., 3., 4.\n"})
    {
      const TemporaryFile left(deck(other), ".inp");
      says(imported(left.path).second, "*RIGID BODY (an analytical surface)");
    }
}



// Reference nodes 9 (motion) and 10 (rotation) of the top of a cube.
TEST_CASE("import: rigid bodies and couplings are obstacles that are attached")
{
  const auto deck = [](const std::string &coupling, const std::string &loads) {
    return cube + "*NODE\n9, 0.5, 0.5, 3.\n10, 0.5, 0.5, 3.\n*NSET, NSET=head\n5, 6, 7, 8\n" +
           "*ELSET, ELSET=e\n1\n*SURFACE, NAME=top\n1, S2\n" + coupling + of_cube +
           "*SOLID SECTION, ELSET=e, MATERIAL=m\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n4, 1, 3\n" +
           "*STEP\n*STATIC\n1., 1.\n" + loads + "*END STEP\n";
  };
  const std::string rigid = "*RIGID BODY, NSET=head, REF NODE=9, ROT NODE=10\n",
                    coupling =
                      "*COUPLING, REF NODE=9, SURFACE=top, CONSTRAINT NAME=c\n*KINEMATIC\n";
  for (const auto &[couples, loads] :
       {std::make_pair(rigid,
                       "*CLOAD\n9, 3, -4.\n10, 2, 5.\n*BOUNDARY\n9, 1, 1, 0.1\n10, 3, 3, 0.2\n"),
        {coupling, "*CLOAD\n9, 3, -4.\n9, 5, 5.\n*BOUNDARY\n9, 1, 1, 0.1\n9, 6, 6, 0.2\n"},
        {coupling + "1, 3\n",
         "*CLOAD\n9, 3, -4.\n9, 5, 5.\n*BOUNDARY\n9, 1, 1, 0.1\n9, 6, 6, 0.2\n"}})
    {
      CAPTURE(couples);
      const TemporaryFile file(deck(couples, loads), ".inp");
      const auto [text, messages] = imported(file.path);
      const Scene<3> scene        = checked<3>(text);
      CHECK(messages.empty());
      REQUIRE(scene.pairs.size() == 1);
      CHECK(scene.pairs[0].is_tied);
      REQUIRE(scene.obstacles.size() == 1);
      const RigidBody<3> &body = scene.obstacles[0].body;
      CHECK(scene.obstacles[0].shape->is_attached());
      CHECK(body.reference == Point<3>(0.5, 0.5, 3));
      CHECK(body.displacement.value({}, 0.5)[0] == doctest::Approx(0.05));
      CHECK(body.rotation.value({}, 0.5)[2] == doctest::Approx(0.1));
      CHECK(body.force.value({}, 0.5)[2] == doctest::Approx(-2));
      CHECK(body.moment.value({}, 0.5)[1] == doctest::Approx(2.5));
      for (const unsigned int i : {1, 2, 3, 4})
        CHECK(body.is_free(i));
      CHECK_FALSE(body.is_free(0));
      CHECK_FALSE(body.is_free(5));
    }
  // What is left out is said.
  const auto warns =
    [&](const std::string &couples, const std::string &loads, const std::string &of) {
      const TemporaryFile file(deck(couples, loads), ".inp");
      says(imported(file.path).second, of);
    };
  const std::string load = "*CLOAD\n5, 3, 1.\n";
  warns(coupling + "1\n", "*CLOAD\n9, 1, 1.\n", "*KINEMATIC of some components only");
  // Two nodes cannot carry the moment about the line through them.
  warns("*RIGID BODY, NSET=edge, REF NODE=9\n*NSET, NSET=edge\n5, 6\n",
        "*CLOAD\n9, 2, 1.\n",
        "no whole face");
  // At large deformation equations do not follow.
  std::string finite =
    deck("*NSET, NSET=some\n1, 5, 6, 7, 8\n*RIGID BODY, NSET=some, REF NODE=9\n", load);
  const std::string step = "*STEP\n";
  finite.replace(finite.find(step), step.size(), "*STEP, NLGEOM\n");
  const TemporaryFile large(finite, ".inp");
  says(imported(large.path).second, "1 nodes of 'some'");
  warns("*RIGID BODY, NSET=edge, REF NODE=9\n*NSET, NSET=edge\n5, 6\n",
        "*CLOAD\n9, 3, 1.\n",
        "*CLOAD at 1 nodes");
  warns(rigid, "*BOUNDARY\n5, 4, 4\n", "*BOUNDARY of rotations");
  warns(rigid, "*CLOAD\n5, 4, 1.\n", "*CLOAD of moments");
  // A plane surface that follows along its normal alone slides on its reference.
  const TemporaryFile sliding(deck(coupling + "3\n", "*CLOAD\n9, 3, -4.\n"), ".inp");
  const Scene<3>      slides = checked<3>(imported(sliding.path).first);
  REQUIRE(slides.pairs.size() == 1);
  CHECK_FALSE(slides.pairs[0].is_tied);
  CHECK_FALSE(slides.pairs[0].can_separate);
  REQUIRE(slides.obstacles.size() == 1);
  for (const unsigned int i : {2, 3, 4})
    CHECK(slides.obstacles[0].body.is_free(i));
  for (const unsigned int i : {0, 1, 5})
    CHECK_FALSE(slides.obstacles[0].body.is_free(i));
  // The element of the reference node gives *DISTRIBUTING COUPLING its name.
  const std::string older =
    "*ELEMENT, TYPE=DCOUP3D, ELSET=d\n77, 9\n*DISTRIBUTING COUPLING, ELSET=d\n";
  const TemporaryFile weighted(deck(older + "head, 1.\n", "*CLOAD\n9, 3, -4.\n"), ".inp");
  const auto [with_weights, none] = imported(weighted.path);
  CHECK(none.empty());
  const Scene<3> distributed = checked<3>(with_weights);
  REQUIRE(distributed.loads.size() == 1);
  CHECK(distributed.loads[0].total_force.value({}, 0.5)[2] == doctest::Approx(-2));
  warns(older + "5, 1.\n6, 2.\n7, 1.\n8, 1.\n", "*CLOAD\n9, 3, -4.\n", "its weights");
  // A distributing coupling is a load, unless its reference node is supported.
  const std::string distributing = "*COUPLING, REF NODE=9, SURFACE=top\n*DISTRIBUTING\n1, 3\n";
  warns(distributing, "*BOUNDARY\n9, 1, 1, 0.1\n", "*DISTRIBUTING with a support");
  const TemporaryFile file(deck(distributing, "*CLOAD\n9, 3, -4.\n9, 5, 5.\n"), ".inp");
  const auto [text, messages] = imported(file.path);
  const Scene<3> scene        = checked<3>(text);
  CHECK(messages.empty());
  REQUIRE(scene.loads.size() == 1);
  CHECK(scene.loads[0].reference == std::vector<double>{0.5, 0.5, 3});
  CHECK(scene.loads[0].total_force.value({}, 0.5)[2] == doctest::Approx(-2));
  CHECK(scene.loads[0].total_moment.value({}, 0.5)[1] == doctest::Approx(2.5));
}



// Supports whose values are not in the deck may have constrained bodies, as friction may.
TEST_CASE("import: stabilisation forces are to be checked where supports are left out")
{
  const auto suspects = [](const std::string &support) {
    const TemporaryFile file(cube + "*ELSET, ELSET=e\n1\n" + of_cube +
                               "*SOLID SECTION, ELSET=e, MATERIAL=m\n*BOUNDARY\n1, 1, 3\n" +
                               "*STEP\n*STATIC\n1., 1.\n" + support +
                               "*CLOAD\n5, 3, 1.\n*END STEP\n",
                             ".inp");
    return imported(file.path).first.find("were not imported may have constrained bodies") !=
           std::string::npos;
  };
  CHECK_FALSE(suspects(""));
  for (const std::string support : {"*BOUNDARY, FIXED\n2, 1, 3\n",
                                    "*BOUNDARY, USER\n2, 1, 3\n",
                                    "*BOUNDARY, SUBMODEL\n2, 1, 3\n",
                                    "*BOUNDARY\n2, NOWARP\n"})
    {
      CAPTURE(support);
      CHECK(suspects(support));
    }
}



// The second of three cubes on each other is removed, and with it what connects the others.
TEST_CASE("import: elements that are removed in the first step are not in the mesh")
{
  const auto with = [](const std::string &first, const std::string &second) {
    const std::string step = "*STEP\n*STATIC\n1., 1.\n", end = "*END STEP\n";
    std::string       text = "*NODE\n";
    for (unsigned int k = 0, n = 1; k < 4; ++k)
      for (const std::string at : {"0, 0, ", "1, 0, ", "1, 1, ", "0, 1, "})
        text += std::to_string(n++) + ", " + at + std::to_string(k) + "\n";
    return text + "*ELEMENT, TYPE=C3D8, ELSET=e\n1, 1, 2, 3, 4, 5, 6, 7, 8\n" +
           "2, 5, 6, 7, 8, 9, 10, 11, 12\n3, 9, 10, 11, 12, 13, 14, 15, 16\n*ELSET, ELSET=out\n2\n" +
           of_cube + "*SOLID SECTION, ELSET=e, MATERIAL=m\n*BOUNDARY\n1, 1, 3\n" + step + first +
           end + step + second + end;
  };
  const std::string   change = "*MODEL CHANGE, TYPE=ELEMENT, ";
  const TemporaryFile file(with(change + "REMOVE\nout\n", ""), ".inp");
  const auto [text, messages] = imported(file.path);
  CHECK(messages.empty());
  CHECK(checked<3>(text).bodies.size() == 2);
  // A pair whose surface is removed acts nowhere, and nothing of it is left out.
  const TemporaryFile pair(
    with("*SURFACE, NAME=a\n1, S2\n*SURFACE, NAME=b\n2, S2\n*SURFACE INTERACTION, NAME=i\n"
         "*CONTACT PAIR, INTERACTION=i\na, b\n" +
           change + "REMOVE\nout\n",
         ""),
    ".inp");
  CHECK(imported(pair.path).second.empty());
  const TemporaryFile back(with(change + "REMOVE\nout\n", change + "ADD\nout\n"), ".inp");
  const auto [whole, reports] = imported(back.path);
  CHECK(checked<3>(whole).bodies.size() == 1);
  says(reports, "*MODEL CHANGE (elements are there at all times)");
}



// The faces x = 0 and y = 0 of a cube are a right angle apart about z.
TEST_CASE("import: cyclic ties are tied pairs with a rotated master")
{
  for (const auto &[slave, master, angle] :
       {std::make_tuple("x0", "y0", 90.), std::make_tuple("y0", "x0", -90.)})
    {
      const TemporaryFile file(
        cube + "*ELSET, ELSET=e\n1\n*SURFACE, NAME=y0\n1, S3\n*SURFACE, NAME=x0\n1, S6\n" +
          of_cube + "*SOLID SECTION, ELSET=e, MATERIAL=m\n*TIE, CYCLIC SYMMETRY, NAME=t\n" + slave +
          ", " + master + "\n*CYCLIC SYMMETRY MODEL, N=4, TIE=t\n0, 0, -1, 0, 0, 1\n" +
          "*STEP\n*STATIC\n1., 1.\n*END STEP\n",
        ".inp");
      const auto [text, messages] = imported(file.path);
      const Scene<3> scene        = checked<3>(text);
      CHECK(messages.empty());
      REQUIRE(scene.pairs.size() == 1);
      const ContactPair<3> &pair = scene.pairs[0];
      CHECK(pair.is_tied);
      CHECK(pair.image.rotation == doctest::Approx(angle));
      const Point<3> corner = angle > 0 ? Point<3>(1, 0, 0.5) : Point<3>(0, 1, 0.5),
                     image  = angle > 0 ? Point<3>(0, 1, 0.5) : Point<3>(1, 0, 0.5);
      CHECK(pair.image.of(corner).distance(image) < 1e-14);
      CHECK(pair.image.origin_of(image).distance(corner) < 1e-14);
    }
}



// Cylindrical axes about z through the middle of the cube, and x' along y at the upper nodes.
TEST_CASE("import: supports and forces in the axes of *TRANSFORM")
{
  const auto deck = [](const std::string &loads) {
    return cube + "*ELSET, ELSET=e\n1\n*NSET, NSET=low\n1, 2, 3, 4\n*NSET, NSET=up\n5, 6\n" +
           "*NSET, NSET=all\n1, 2, 3, 4, 5, 6, 7, 8\n" + of_cube +
           "*DENSITY\n2.\n*SOLID SECTION, ELSET=e, MATERIAL=m\n" +
           "*TRANSFORM, NSET=low, TYPE=C\n0.5, 0.5, 0, 0.5, 0.5, 1\n" +
           "*TRANSFORM, NSET=up\n0, 1, 0, -1, 0, 0\n*STEP\n*STATIC\n1., 1.\n" + loads +
           "*END STEP\n";
  };
  const TemporaryFile file(
    deck(
      "*BOUNDARY\nlow, 1, 1, 0.1\nlow, 3, 3\n*CLOAD\nup, 1, 3.\n*DLOAD\ne, CENTRIF, 5., 0, 2, 0, 1, 0, 0\n"),
    ".inp");
  const auto [text, messages] = imported(file.path);
  const Scene<3> scene        = checked<3>(text);
  CHECK(messages.empty());
  REQUIRE(scene.supports.size() == 1);
  const Support<3>  &support = scene.supports[0];
  const Tensor<1, 3> u       = support.displacement_at({1, 1, 0}, 1);
  CHECK((u - Tensor<1, 3>({0.1 / std::sqrt(2.), 0.1 / std::sqrt(2.), 0})).norm() < 1e-14);
  // There is no radial direction on the axis.
  CHECK(std::isnan(support.displacement_at({0.5, 0.5, 0}, 1).norm()));
  CHECK_FALSE(support.displacement.prescribed(1));
  REQUIRE(scene.loads.size() == 2);
  CHECK((scene.loads[0].force_at({0, 0, 1}, 1) - Tensor<1, 3>({0, 3, 0})).norm() < 1e-14);
  // Density 2 times 5 times the distance from the x axis through y = 2.
  CHECK((scene.loads[1].body_force_at({7, 3, 4}, 1) - Tensor<1, 3>({0, 10, 40})).norm() < 1e-12);
  const TemporaryFile mixed(deck("*CLOAD\nall, 1, 3.\n"), ".inp");
  says(imported(mixed.path).second, "on nodes with the axes of different *TRANSFORM");
}



TEST_CASE("import: *MODEL CHANGE and *CHANGE FRICTION act from the beginning of their step")
{
  const std::string step = "*STEP\n*STATIC\n1., 1.\n", end = "*END STEP\n";
  const auto        with = [&](const std::string &first, const std::string &second) {
    return cube +
           "*NODE\n11, 0, 0, 1\n12, 1, 0, 1\n13, 1, 1, 1\n14, 0, 1, 1\n15, 0, 0, 2\n16, 1, 0, 2\n"
                  "17, 1, 1, 2\n18, 0, 1, 2\n*ELEMENT, TYPE=C3D8\n2, 11, 12, 13, 14, 15, 16, 17, 18\n"
                  "*ELSET, ELSET=e\n1, 2\n*SURFACE, NAME=s\n2, S1\n*SURFACE, NAME=m\n1, S2\n" +
           of_cube +
           "*SOLID SECTION, ELSET=e, MATERIAL=m\n*SURFACE INTERACTION, NAME=i\n*FRICTION\n0.1, 0.\n"
                  "*CONTACT PAIR, INTERACTION=i, TYPE=SURFACE TO SURFACE\ns, m\n" +
           step + first + end + step + second + end;
  };
  const std::string change = "*MODEL CHANGE, TYPE=CONTACT PAIR, ", of_pair = "\ns, m\n";
  const auto        pairs = [&](const std::string &first, const std::string &second) {
    const TemporaryFile file(with(first, second), ".inp");
    const auto [text, messages] = imported(file.path);
    CHECK(messages.empty());
    return checked<3>(text).pairs;
  };
  const auto late = pairs(change + "REMOVE" + of_pair, change + "ADD" + of_pair);
  REQUIRE(late.size() == 1);
  CHECK_FALSE(late[0].acts(1));
  CHECK(late[0].acts(1.5));
  const auto early = pairs("", change + "REMOVE" + of_pair);
  REQUIRE(early.size() == 1);
  CHECK(early[0].acts(1));
  CHECK_FALSE(early[0].acts(1.5));
  CHECK(pairs(change + "REMOVE" + of_pair, "").empty());
  const auto slippery = pairs("", "*CHANGE FRICTION, INTERACTION=i\n*FRICTION\n0.3, 0.\n");
  REQUIRE(slippery.size() == 1);
  CHECK(slippery[0].friction.value({}, 1, 1, 0) == doctest::Approx(0.1));
  CHECK(slippery[0].friction.value({}, 1.5, 1, 0) == doctest::Approx(0.3));
  // Another law is another pair, from there on, with the friction that there was.
  const std::string behaviour =
    "*CHANGE SURFACE BEHAVIOR, INTERACTION=i\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n7.\n";
  const auto softened = pairs("", behaviour + change + "REMOVE" + of_pair);
  CHECK(softened.size() == 1);
  const auto soft = pairs("", behaviour + "*CHANGE FRICTION, INTERACTION=i\n*FRICTION\n0.3, 0.\n");
  REQUIRE(soft.size() == 2);
  for (const unsigned int later : {0, 1})
    {
      CHECK(soft[later].acts(1) == (later == 0));
      CHECK(soft[later].acts(1.5) == (later == 1));
      CHECK(soft[later].compliance.is_rigid() == (later == 0));
      CHECK(soft[later].friction.value({}, 1.5, 1, 0) == doctest::Approx(later == 0 ? 0.1 : 0.3));
    }
}
