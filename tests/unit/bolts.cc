// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus.h"
#include "mesh_import/import_steps.h"

#include <algorithm>
#include <set>

#include "deck_helpers.h"
#include "mesh_helpers.h"

using namespace dealii;
using namespace Signorini;
using namespace MeshTests;
using namespace DeckTests;

namespace
{
  /// n x m unit squares with nodes by rows.
  MeshFile
  squares(const unsigned int n, const unsigned int m)
  {
    MeshFile file;
    for (unsigned int j = 0; j <= m; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        file.nodes.emplace_back(i, j, 0);
    const auto node = [&](const unsigned int i, const unsigned int j) { return j * (n + 1) + i; };
    for (unsigned int j = 0; j < m; ++j)
      for (unsigned int i = 0; i < n; ++i)
        file.elements.push_back({MeshFile::Shape::quadrilateral,
                                 "CPE4",
                                 file.elements.size() + 1,
                                 {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}});
    return file;
  }

  std::set<unsigned int>
  nodes_of_elements(const MeshFile &file, const std::vector<unsigned int> &elements)
  {
    std::set<unsigned int> result;
    for (const unsigned int e : elements)
      result.insert(file.elements[e].nodes.begin(), file.elements[e].nodes.end());
    return result;
  }

  bool
  are_disjoint(const std::set<unsigned int> &a, const std::set<unsigned int> &b)
  {
    return std::none_of(a.begin(), a.end(), [&](const unsigned int x) { return b.count(x) > 0; });
  }
} // namespace



TEST_CASE("a mesh that is cut from side to side has two pieces")
{
  MeshFile file = squares(2, 2);
  file.groups.push_back({"Section", {}, {{3, 4}, {4, 5}}, {}});
  file.groups.push_back({"side", {}, {{2, 5}, {5, 8}}, {2, 5, 8}});
  const auto copies = cut_mesh(file, "SECTION", "other");
  CHECK(copies.size() == 3);
  CHECK(file.nodes.size() == 12);
  CHECK(are_disjoint(nodes_of_elements(file, {0, 1}), nodes_of_elements(file, {2, 3})));
  for (const auto &[node, copy] : copies)
    CHECK(file.nodes[node].distance(file.nodes[copy]) == 0);
  // Either side has its own nodes in both groups, and each face of the boundary those of its cell.
  const auto is_of_cells = [&](const MeshFile::Nodes &face) {
    return std::any_of(file.elements.begin(), file.elements.end(), [&](const auto &element) {
      return std::all_of(face.begin(), face.end(), [&](const unsigned int node) {
        return std::count(element.nodes.begin(), element.nodes.end(), node) > 0;
      });
    });
  };
  CHECK(group(file, "other").faces.size() == 2);
  for (const char *const name : {"Section", "other", "side"})
    for (const MeshFile::Nodes &face : group(file, name).faces)
      CHECK(is_of_cells(face));
  CHECK(nodes_of_elements(file, {0, 1, 2, 3}).size() == 12);
  CHECK(group(file, "side").nodes.size() == 4);
}



TEST_CASE("surfaces along which a mesh cannot be cut are refused")
{
  const auto fails = [](const std::vector<MeshFile::Nodes> &faces, const std::string &why) {
    MeshFile file = squares(2, 2);
    file.groups.push_back({"section", {}, faces, {}});
    CHECK_THROWS_WITH_AS(cut_mesh(file, "section", "other"),
                         doctest::Contains(why.c_str()),
                         SceneError);
  };
  fails({}, "no surface with faces");
  fails({{0, 1}}, "not inside of the mesh");
  fails({{3, 4}, {4, 7}}, "not plane");
  fails({{3, 4}}, "ends inside");
}



namespace
{
  /// Two cubes, one on the other, with a pretension between them.
  std::string
  bolt_deck(const std::string &section, const std::string &steps)
  {
    std::string nodes = "*NODE\n";
    for (unsigned int k = 0, n = 1; k < 3; ++k)
      for (unsigned int j = 0; j < 2; ++j)
        for (unsigned int i = 0; i < 2; ++i, ++n)
          nodes += std::to_string(n) + ", " + std::to_string(i) + ", " + std::to_string(j) + ", " +
                   std::to_string(k) + "\n";
    return nodes +
           "77, 0.5, 0.5, 1\n*ELEMENT, TYPE=C3D8, ELSET=all\n1, 1, 2, 4, 3, 5, 6, 8, 7\n"
           "2, 5, 6, 8, 7, 9, 10, 12, 11\n*SURFACE, NAME=middle\n1, S2\n*NSET, NSET=ends\n"
           "1, 2, 3, 4, 9, 10, 11, 12\n*NSET, NSET=corner\n5\n*MATERIAL, NAME=m\n*ELASTIC\n1000, 0.3\n"
           "*SOLID SECTION, ELSET=all, MATERIAL=m\n" +
           section + "*BOUNDARY\nends, 1, 3\n" + steps;
  }

  const std::string tighten = "*STEP\n*STATIC\n1, 1\n*CLOAD\n77, 1, 50\n*END STEP\n",
                    lock    = "*STEP\n*STATIC\n1, 1\n*BOUNDARY, FIXED\n77, 1, 1\n*END STEP\n",
                    named   = "*PRE-TENSION SECTION, SURFACE=middle, NODE=77\n";
} // namespace



TEST_CASE("import: the pretension of a bolt")
{
  const TemporaryFile file(bolt_deck(named + "0, 0, 1\n", tighten + lock), ".inp");
  const auto [text, messages] = imported(file.path);
  CHECK(messages.empty());
  const Scene<3> scene = checked<3>(text);
  CHECK(scene.bodies.size() == 2);
  REQUIRE(scene.pairs.size() == 1);
  const Pretension<3> &one = scene.pairs[0].pretension;
  CHECK(scene.pairs[0].is_tied);
  const RigidBody<3> body = one.body("bolt");
  CHECK(body.is_free(0));
  CHECK(body.force.value({}, 0.5)[0] == doctest::Approx(25));
  CHECK(one.driven.until == 1);
  // The copy of a node is in the sets of that, with a number of its own.
  const AbaqusDeck mesh = read_abaqus_deck(file.path);
  CHECK(mesh.nodes.find("corner")->members.size() == 2);
  CHECK(mesh.mesh.numbers.at("").size() == 13 + 4);
}



TEST_CASE("import: pretensions by a shortening, and those that are left out")
{
  const auto with = [](const std::string &section, const std::string &steps) {
    const TemporaryFile file(bolt_deck(section, steps), ".inp");
    const auto          result = imported(file.path);
    return std::pair(result, result.second.empty() ? checked<3>(result.first) : Scene<3>());
  };
  const std::string shorten  = "*STEP\n*STATIC\n1, 1\n*BOUNDARY\n77, 1, 1, 0.01\n*END STEP\n";
  const auto [result, scene] = with(named, shorten);
  CHECK(result.second.empty());
  REQUIRE(scene.pairs.size() == 1);
  CHECK_FALSE(scene.pairs[0].pretension.body("bolt").is_free(0));
  CHECK(scene.pairs[0].pretension.body("bolt").displacement.value({}, 0.5)[0] ==
        doctest::Approx(0.005));
  CHECK(with(named + "0, 1, 0\n", tighten).first.second.find("in another direction") !=
        std::string::npos);
  CHECK(with("*PRE-TENSION SECTION, ELEMENT=4, NODE=77\n", tighten).first.second.find("of line") !=
        std::string::npos);
}



TEST_CASE("import: equations between displacements")
{
  const auto with = [](const std::string &equations, const std::string &steps) {
    return bolt_deck(
      "*NODE\n88, 0, 0, 0\n89, 0, 0, 0\n*NSET, NSET=up\n5, 6\n*NSET, NSET=down\n7, 8\n" + equations,
      steps);
  };
  const auto messages = [&](const std::string &equations, const std::string &steps) {
    const TemporaryFile file(with(equations, steps), ".inp");
    return imported(file.path).second;
  };
  const std::string load = "*STEP\n*STATIC\n1, 1\n*CLOAD\n5, 1, 1.\n*END STEP\n",
                    move = "*STEP\n*STATIC\n1, 1\n*BOUNDARY\n88, 1, 1, 0.5\n*END STEP\n";
  // Terms on several lines, two equations of sets, and one with a right-hand side.
  const TemporaryFile file(with("*EQUATION\n2\nup, 1, 1.,\ndown, 1, -2.\n2\n5, 2, 3., 88, 1, -1.\n",
                                move),
                           ".inp");
  const auto [text, none] = imported(file.path);
  CHECK(none.empty());
  const Scene<3> scene = checked<3>(text);
  REQUIRE(scene.equations.size() == 2);
  REQUIRE(scene.equations[0].equations.size() == 2);
  const auto &first = scene.equations[0].equations[1];
  REQUIRE(first.size() == 2);
  CHECK(first[0].node == scene.bodies[0].name + ".6");
  CHECK(first[1].node == scene.bodies[0].name + ".8");
  CHECK(first[1].factor == -2);
  CHECK(first[1].component == 0);
  REQUIRE(scene.equations[1].equations[0].size() == 1);
  CHECK(scene.equations[1].value.value({}, 1) == doctest::Approx(0.5));
  // A node on no solid that nothing prescribes would be an unknown.
  CHECK(messages("*EQUATION\n2\n5, 2, 3., 89, 1, -1.\n2\n6, 2, 3., 89, 1, -1.\n", load)
          .find("2 lines with nodes that are on no solid and free") != std::string::npos);
  // It is none where a single equation defines what it does.
  CHECK(messages("*EQUATION\n2\n89, 1, 1., 5, 2, -1.\n", load).empty());
  CHECK(messages("*EQUATION\n2\n5, 4, 3., 6, 4, -1.\n", load).find("of rotations") !=
        std::string::npos);
  // Components of nodes with other axes: radial is along y for node 7, at (0, 1), about z.
  const TemporaryFile turned(
    with(
      "*NSET, NSET=one\n7\n*TRANSFORM, NSET=one, TYPE=C\n0, 0, 0, 0, 0, 1\n*EQUATION\n2\n7, 1, 1., 5, 1, -1.\n",
      load),
    ".inp");
  const Scene<3> radial = checked<3>(imported(turned.path).first);
  REQUIRE(radial.equations.size() == 1);
  const auto &terms = radial.equations[0].equations[0];
  REQUIRE(terms.size() == 2);
  CHECK(terms[0].component == 1);
  CHECK(terms[0].factor == doctest::Approx(1));
}



namespace
{
  /// The largest error of the equations of a deck for a rigid motion of all nodes.
  double
  error_of_rigid_motion(const std::string  &file,
                        const Scene<3>     &scene,
                        const Tensor<1, 3> &shift,
                        const Tensor<1, 3> &spin)
  {
    const AbaqusDeck deck  = read_abaqus_deck(file);
    double           error = 0;
    for (const auto &one : scene.equations)
      for (const auto &terms : one.equations)
        {
          double sum = -one.value.value({}, 1);
          for (const auto &term : terms)
            {
              const unsigned long number = std::stoul(term.node.substr(term.node.find('.') + 1));
              const Point<3>      x      = deck.mesh.nodes[deck.mesh.numbers.at("").at(number)];
              sum += term.factor * (shift + cross_product_3d(spin, x))[term.component];
            }
          error = std::max(error, std::abs(sum));
        }
    return error;
  }

  /// The sums of the forces on single nodes at t = 1, and of their moments about the origin.
  std::pair<Tensor<1, 3>, Tensor<1, 3>>
  resultants(const std::string &file, const Scene<3> &scene)
  {
    const AbaqusDeck                      deck = read_abaqus_deck(file);
    std::pair<Tensor<1, 3>, Tensor<1, 3>> sum;
    for (const Load<3> &load : scene.loads)
      for (const std::string &node : load.nodes.sets)
        {
          const unsigned long number = std::stoul(node.substr(node.find('.') + 1));
          const Point<3>      x      = deck.mesh.nodes[deck.mesh.numbers.at("").at(number)];
          const Tensor<1, 3>  force  = load.force_at(x, 1);
          sum.first += force;
          sum.second += cross_product_3d(x, force);
        }
    return sum;
  }

  unsigned int
  n_equations(const Scene<3> &scene)
  {
    unsigned int n = 0;
    for (const auto &one : scene.equations)
      n += one.equations.size();
    return n;
  }
} // namespace



// A rigid motion satisfies all of them; of the rotation MEANROT measures the component along z.
TEST_CASE("import: linearised equations of *MPC")
{
  const std::string load =
    "*STEP\n*STATIC\n1, 1\n*CLOAD\n5, 1, 1.\n*BOUNDARY\n88, 1, 1, 0.01\n*END STEP\n";
  const auto with = [&](const std::string &mpcs) {
    return bolt_deck("*NODE\n88, 0, 0, 2\n*NSET, NSET=top\n5, 6, 7, 8\n*MPC\n" + mpcs, load);
  };
  const TemporaryFile file(
    with("BEAM, 5, 7\nPLANE, top\nMEANROT, 5, 5, 5, 6, 6, 6, 7, 7, 7\n0, 8, 8, 8, 88\n"), ".inp");
  const auto [text, messages] = imported(file.path);
  CHECK(messages.empty());
  const Scene<3> scene = checked<3>(text);
  CHECK(n_equations(scene) == 3);
  CHECK(error_of_rigid_motion(
          file.path, scene, Tensor<1, 3>({1, 2, 3}), Tensor<1, 3>({0.02, -0.03, 0.01})) < 1e-9);
  const auto messages_of = [&](const std::string &mpcs) {
    const TemporaryFile one(with(mpcs), ".inp");
    return imported(one.path).second;
  };
  CHECK(messages_of("DIST, 5, 5, 5, 6, 6, 6, 88\n").find("DIST") != std::string::npos);
  CHECK(messages_of("STRAIGHT, 5, 6, 7\n").find("not on one line") != std::string::npos);
}



// In-plane components follow a point that moves freely but for its rotation: of eight equations
// two are used up for its motion.
TEST_CASE("import: kinematic couplings of some components")
{
  const auto with = [&](const std::string &coupling, const std::string &acts) {
    return bolt_deck("*NODE\n88, 0.3, 0.2, 1\n*NSET, NSET=top\n5, 6, 7, 8\n" + coupling,
                     "*STEP\n*STATIC\n1, 1\n*BOUNDARY\n88, 6, 6, 0.01\n" + acts + "*END STEP\n");
  };
  for (
    const std::string coupling :
    {"*SURFACE, NAME=face\n1, S2\n*COUPLING, REF NODE=88, SURFACE=face, CONSTRAINT NAME=c\n*KINEMATIC\n1, 2\n",
     "*KINEMATIC COUPLING, REF NODE=88\ntop, 1, 2\n"})
    {
      const TemporaryFile file(with(coupling, ""), ".inp");
      const auto [text, messages] = imported(file.path);
      CHECK(messages.empty());
      const Scene<3> scene = checked<3>(text);
      CHECK(n_equations(scene) == 6);
      CHECK(error_of_rigid_motion(
              file.path, scene, Tensor<1, 3>({1, 2, 3}), Tensor<1, 3>({0, 0, 0.01})) < 1e-9);
      const TemporaryFile forced(with(coupling, "*CLOAD\n88, 1, 1.\n"), ".inp");
      const auto [forced_text, none] = imported(forced.path);
      CHECK(none.empty());
      const Tensor<1, 3> force = resultants(forced.path, checked<3>(forced_text)).first;
      CHECK((force - Tensor<1, 3>({1, 0, 0})).norm() < 1e-12);
    }
}



// Three corners of the middle plane are on no whole face.
TEST_CASE("import: a rigid body of single nodes carries force and moment of its reference node")
{
  const std::string body = "*NODE\n88, 0.3, 0.2, 1.5\n89, 0.3, 0.2, 1.5\n*NSET, NSET=top\n5, 6, 7\n"
                           "*RIGID BODY, NSET=top, REF NODE=88, ROT NODE=89\n",
                    loads =
                      "*STEP\n*STATIC\n1, 1\n*CLOAD\n88, 1, 1.\n88, 3, 3.\n89, 2, 5.\n*END STEP\n";
  const TemporaryFile file(bolt_deck(body, loads), ".inp");
  const auto [text, messages] = imported(file.path);
  CHECK(messages.empty());
  const Scene<3> scene = checked<3>(text);
  CHECK(n_equations(scene) == 3);
  const Tensor<1, 3> shift({1, 2, 3}), spin({0.02, -0.03, 0.01}), force({1, 0, 3});
  CHECK(error_of_rigid_motion(file.path, scene, shift, spin) < 1e-9);
  const auto [sum, moment] = resultants(file.path, scene);
  CHECK((sum - force).norm() < 1e-12);
  CHECK((moment - cross_product_3d(Tensor<1, 3>({0.3, 0.2, 1.5}), force) - Tensor<1, 3>({0, 5, 0}))
          .norm() < 1e-12);
}
