// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.h"
#include "mesh/transformed_manifold.h"

#include <cmath>
#include <set>

#include "mesh_helpers.h"

using namespace dealii;
using namespace Signorini;
using namespace MeshTests;

namespace
{
  const double pi = numbers::PI;

  /// Smallest Jacobian over the product of the edge lengths, at the vertices of straight cells.
  template <int dim>
  double
  worst_quality(const Triangulation<dim> &triangulation)
  {
    double worst = 1;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          Tensor<2, dim> edges;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int other = v ^ (1u << d);
              edges[d] = (other > v ? 1 : -1) * (cell->vertex(other) - cell->vertex(v));
              edges[d] /= edges[d].norm();
            }
          worst = std::min(worst, determinant(edges));
        }
    return worst;
  }



  /// What a boundary point must make zero, by the name of the boundary.
  template <int dim>
  using Geometry = std::map<std::string, std::function<double(const Point<dim> &)>>;

  template <int dim>
  void
  check_boundaries(const Triangulation<dim>       &triangulation,
                   const std::vector<std::string> &names,
                   const Geometry<dim>            &geometry)
  {
    std::set<std::string> seen;
    double                worst = 0;
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary())
        {
          const std::string name = names.at(face->boundary_id());
          REQUIRE(geometry.count(name) == 1);
          seen.insert(name);
          for (const unsigned int v : face->vertex_indices())
            worst = std::max(worst, std::abs(geometry.at(name)(face->vertex(v))));
        }
    CHECK(worst < 1e-12);
    CHECK(seen.size() == geometry.size());
  }



  template <int dim>
  void
  check_mesh(const std::string   &name,
             const Keys          &keys,
             const double         exact_volume,
             const double         quality,
             const Geometry<dim> &geometry)
  {
    const auto            maker = generator<dim>(name, keys);
    const CoarseMesh<dim> mesh  = maker->generate();
    CHECK(mesh.boundaries == maker->boundaries());

    Triangulation<dim>  triangulation;
    std::vector<double> errors;
    create(triangulation, mesh);
    for (unsigned int level = 0; level < 4; ++level)
      {
        if (level > 0)
          triangulation.refine_global();
        errors.push_back(std::abs(volume(triangulation) / exact_volume - 1));
        CHECK(worst_quality(triangulation) > quality);
        if (level > 1)
          CHECK(errors[level] < std::max(1e-11, errors[level - 1] / 13));
      }
    CHECK(errors.back() < 1e-5);
    check_boundaries(triangulation, maker->boundaries(), geometry);
  }



  template <int dim>
  std::function<double(const Point<dim> &)>
  at(const unsigned int axis, const double value)
  {
    return [=](const Point<dim> &p) { return p[axis] - value; };
  }



  /// Distance from the sphere (2D: circle).
  template <int dim>
  std::function<double(const Point<dim> &)>
  around(const Point<dim> &center, const double radius)
  {
    return [=](const Point<dim> &p) { return p.distance(center) - radius; };
  }



} // namespace



TEST_CASE("box")
{
  check_mesh<2>(
    "box",
    {{"Corners", "1,2 : 4,4"}, {"Subdivisions", "3,2"}, {"Grading", "4, 1/2"}},
    6,
    0.999,
    {{"left", at<2>(0, 1)}, {"right", at<2>(0, 4)}, {"bottom", at<2>(1, 2)}, {"top", at<2>(1, 4)}});
  check_mesh<3>("box",
                {{"Corners", "0,0,0 : 1,2,3"}, {"Subdivisions", "1,2,3"}, {"Grading", "1,1,4"}},
                6,
                0.999,
                {{"left", at<3>(0, 0)},
                 {"right", at<3>(0, 1)},
                 {"front", at<3>(1, 0)},
                 {"back", at<3>(1, 2)},
                 {"bottom", at<3>(2, 0)},
                 {"top", at<3>(2, 3)}});
}



TEST_CASE("grading of a box is the last cell over the first")
{
  const auto mesh =
    generator<2>("box", {{"Corners", "0,0 : 7,1"}, {"Subdivisions", "3,1"}, {"Grading", "4,1"}})
      ->generate();
  std::set<double> x;
  for (const auto &vertex : mesh.vertices)
    x.insert(std::round(vertex[0] * 1e10) / 1e10);
  CHECK(x == std::set<double>{0, 1, 3, 7});
}



TEST_CASE("disc")
{
  const Point<2> c(3, -1);
  const Keys     keys{{"Center", "3,-1"}, {"Radius", "2"}};
  const auto     with = [&](const std::string &part) {
    Keys result = keys;
    result.push_back({"Part", part});
    return result;
  };
  check_mesh<2>("disc", with("full"), 4 * pi, 0.8, {{"arc", around(c, 2)}});
  check_mesh<2>(
    "disc", with("lower half"), 2 * pi, 0.8, {{"arc", around(c, 2)}, {"top", at<2>(1, -1)}});
  check_mesh<2>("disc",
                with("lower right quarter"),
                pi,
                0.8,
                {{"arc", around(c, 2)}, {"top", at<2>(1, -1)}, {"symmetry", at<2>(0, 3)}});
  for (const auto &vertex : generator<2>("disc", with("lower right quarter"))->generate().vertices)
    CHECK((vertex[0] > 3 - 1e-12 && vertex[1] < -1 + 1e-12));
}



TEST_CASE("ring")
{
  const Point<2> c(1, 2);
  const double   area = pi * (3 * 3 - 2 * 2);
  const auto     with = [&](const std::string &part, const std::string &cells) {
    return Keys{{"Center", "1,2"},
                {"Inner radius", "2"},
                {"Outer radius", "3"},
                {"Cells through", "2"},
                {"Cells around", cells},
                {"Part", part}};
  };
  const Geometry<2> whole{{"inner", around(c, 2)}, {"outer", around(c, 3)}};
  auto              half = whole, quarter = whole;
  half["symmetry_y"]    = at<2>(1, 2);
  quarter["symmetry_y"] = at<2>(1, 2);
  quarter["symmetry_x"] = at<2>(0, 1);
  check_mesh<2>("ring", with("full", "7"), area, 0.5, whole);
  check_mesh<2>("ring", with("half", "5"), area / 2, 0.5, half);
  check_mesh<2>("ring", with("lower half", "2"), area / 2, 0.5, half);
  check_mesh<2>("ring", with("quarter", "3"), area / 4, 0.5, quarter);
}



TEST_CASE("tube")
{
  const auto radius = [](const double r) {
    return [=](const Point<3> &p) { return std::hypot(p[0] - 1, p[1] - 2) - r; };
  };
  const Geometry<3> whole{{"inner", radius(2)},
                          {"outer", radius(3)},
                          {"bottom", at<3>(2, 3)},
                          {"top", at<3>(2, 3.5)}};
  auto              quarter = whole;
  quarter["symmetry_x"]     = at<3>(0, 1);
  quarter["symmetry_y"]     = at<3>(1, 2);
  Keys keys{{"Center", "1,2,3"}, {"Inner radius", "2"}, {"Outer radius", "3"}, {"Height", "0.5"}};
  check_mesh<3>("ring", keys, pi * 5 * 0.5, 0.5, whole);
  keys.insert(keys.end(), {{"Part", "quarter"}, {"Cells around", "2"}, {"Layers", "2"}});
  check_mesh<3>("ring", keys, pi * 5 * 0.5 / 4, 0.5, quarter);
}



namespace
{
  /// The plane cuts of a part of a ball about (1,2,3).
  Geometry<3>
  cuts(const std::string &part)
  {
    Geometry<3> result;
    if (part != "full")
      result["top"] = at<3>(2, 3);
    if (part == "lower quarter")
      {
        result["symmetry_x"] = at<3>(0, 1);
        result["symmetry_y"] = at<3>(1, 2);
      }
    return result;
  }

  const std::map<std::string, double> ball_shares{{"full", 1},
                                                  {"lower half", 2},
                                                  {"lower quarter", 8}};
} // namespace



TEST_CASE("sphere")
{
  const Point<3> c(1, 2, 3);
  for (const auto &[part, share] : ball_shares)
    {
      auto geometry      = cuts(part);
      geometry["sphere"] = around(c, 2);
      check_mesh<3>("sphere",
                    {{"Center", "1,2,3"}, {"Radius", "2"}, {"Part", part}},
                    4. / 3 * pi * 8 / share,
                    0.7,
                    geometry);
    }
}



TEST_CASE("shell")
{
  const Point<3> c(1, 2, 3);
  for (const auto &[part, share] : ball_shares)
    {
      auto geometry     = cuts(part);
      geometry["inner"] = around(c, 2);
      geometry["outer"] = around(c, 3);
      check_mesh<3>(
        "shell",
        {{"Center", "1,2,3"}, {"Inner radius", "2"}, {"Outer radius", "3"}, {"Part", part}},
        4. / 3 * pi * (27 - 8) / share,
        0.7,
        geometry);
    }
  const Keys finer{{"Part", "lower quarter"},
                   {"Cells along 45 degrees", "3"},
                   {"Cells through", "2"}};
  CHECK(generator<3>("shell", finer)->generate().cells.size() == 3 * 3 * 3 * 2);
}



TEST_CASE("nonsense in a mesh's section is refused with the key")
{
  says(message_of([] { generator<2>("box", {{"Corners", "0,0 ; 1,1"}}); }), "Corners");
  says(message_of([] { generator<2>("box", {{"Corners", "0,0 : 1"}}); }), "2 coordinates");
  says(message_of([] { generator<2>("box", {{"Corners", "0,0 : -1,1"}}); }), "larger");
  says(message_of([] { generator<3>("box", {{"Subdivisions", "2,2"}}); }), "3 numbers");
  says(message_of([] { generator<2>("ring", {{"Inner radius", "2"}}); }), "smaller");
  says(message_of([] { generator<2>("ring", {{"Cells around", "3"}}); }), "90 degrees");
  says(message_of([] { MeshGenerator<2>::create("shell"); }), "box, disc, ring, file");
}



TEST_CASE("what stays straight needs no manifold, and is found whatever the formula looks like")
{
  const auto box    = [] { return generator<2>("box", {{"Subdivisions", "4,4"}})->generate(); };
  auto       turned = box();
  CHECK(!transform(turned,
                   false,
                   VectorExpression<2>("x*cos(pi/6) - y*sin(pi/6); x*sin(pi/6) + y*cos(pi/6)")));
  CHECK(turned.manifolds.empty());
  CHECK(turned.vertices.back().distance({std::cos(pi / 6) - 0.5, 0.5 + std::cos(pi / 6)}) < 1e-12);
  // Zero at all vertices, and small.
  auto wavy = box();
  CHECK(transform(wavy, false, VectorExpression<2>("x; y + 1e-6*sin(4*pi*x)")));
  CHECK(!wavy.manifolds.empty());
  auto disc = generator<2>("disc", {})->generate();
  CHECK(transform(disc, true, VectorExpression<2>("2*x; y")));
  CHECK(!disc.manifolds.empty());
}



TEST_CASE("a box bent to a ring: refined points are images of the refined box")
{
  auto mesh = generator<2>("box", {{"Subdivisions", "2,3"}})->generate();
  transform(mesh, false, VectorExpression<2>("(2+x)*cos(pi*y); (2+x)*sin(pi*y)"));
  Triangulation<2>    triangulation;
  std::vector<double> errors;
  create(triangulation, mesh);
  for (unsigned int level = 0; level < 4; ++level)
    {
      if (level > 0)
        triangulation.refine_global();
      errors.push_back(std::abs(volume(triangulation) / (pi / 2 * (9 - 4)) - 1));
    }
  CHECK(errors[3] < errors[2] / 13);

  double worst = 0;
  for (const auto &p : triangulation.get_vertices())
    {
      const double x = (p.norm() - 2) * 16, y = std::atan2(p[1], p[0]) / pi * 24;
      worst = std::max({worst, std::abs(x - std::round(x)), std::abs(y - std::round(y))});
    }
  CHECK(worst < 1e-11);
}



TEST_CASE("a crowned block: faces are images of the plane ones")
{
  auto mesh = generator<3>("box", {{"Subdivisions", "2,2,1"}})->generate();
  transform(mesh, false, VectorExpression<3>("1000*x; 1000*y; 1000*(z + z*(x^2+y^2)/6)"));
  Triangulation<3> triangulation;
  create(triangulation, mesh);
  triangulation.refine_global(2);
  const Geometry<3> geometry{{"left", at<3>(0, 0)},
                             {"right", [](const Point<3> &p) { return p[0] / 1000 - 1; }},
                             {"front", at<3>(1, 0)},
                             {"back", [](const Point<3> &p) { return p[1] / 1000 - 1; }},
                             {"bottom", at<3>(2, 0)},
                             {"top", [](const Point<3> &p) {
                                return p[2] / 1000 - 1 - (p[0] * p[0] + p[1] * p[1]) / 6e6;
                              }}};
  check_boundaries(triangulation, mesh.boundaries, geometry);
  CHECK(volume(triangulation) == doctest::Approx(1e9 * (1 + 1. / 9)).epsilon(1e-6));
}



TEST_CASE("a transformed ball: the sphere under the map stays exact, also on its rims")
{
  auto mesh = generator<3>("sphere", {{"Part", "lower quarter"}})->generate();
  transform(mesh, false, VectorExpression<3>("2*x; y; z + (x^2+y^2)/4"));
  Triangulation<3> triangulation;
  create(triangulation, mesh);
  const auto before = [](const Point<3> &p) {
    const double x = p[0] / 2, y = p[1];
    return Point<3>(x, y, p[2] - (x * x + y * y) / 4);
  };
  for (unsigned int level = 0; level < 3; ++level)
    {
      check_boundaries<3>(triangulation,
                          mesh.boundaries,
                          {{"sphere", [&](const Point<3> &p) { return before(p).norm() - 1; }},
                           {"top", [&](const Point<3> &p) { return before(p)[2]; }},
                           {"symmetry_x", at<3>(0, 0)},
                           {"symmetry_y", at<3>(1, 0)}});
      CHECK(worst_quality(triangulation) > 0.2);
      triangulation.refine_global();
    }
  // The map doubles volumes.
  CHECK(volume(triangulation) == doctest::Approx(2 * pi / 6).epsilon(1e-5));
}



TEST_CASE("transformations that cannot be are refused")
{
  const auto attempt = [](const std::string &formulas) {
    return message_of([&] {
      auto mesh = generator<2>("box", {})->generate();
      transform(mesh, false, VectorExpression<2>(formulas));
    });
  };
  says(attempt("x; free"), "free");
  says(attempt("-x; y"), "mirrors");
  says(attempt("x; log(y)"), "no value");
  const InvertibleMap<2> map(VectorExpression<2>("x; y^2"), {Point<2>(0, 1), Point<2>(1, 2)});
  CHECK_THROWS_WITH_AS(map.inverse(Point<2>(0, -1)),
                       doctest::Contains("cannot be inverted"),
                       std::runtime_error);
}



TEST_CASE("a square mapped to a quarter of a disc is inverted near the corner that becomes smooth")
{
  const std::vector<Point<2>> corners = {Point<2>(0, 0),
                                         Point<2>(10, 0),
                                         Point<2>(0, 10),
                                         Point<2>(10, 10)};
  const InvertibleMap<2>      map(VectorExpression<2>("x*sqrt(1 - y^2/200); y*sqrt(1 - x^2/200)"),
                             corners);
  for (const double x : {8.855, 9.7, 9.99})
    for (const double y : {8.5, 9.9})
      CHECK(map.inverse(map.value(Point<2>(x, y))).distance(Point<2>(x, y)) < 1e-6);
}



TEST_CASE("file: an octant of a ball with an exact sphere")
{
  check_mesh<3>("file",
                {{"File", stored_mesh("ball-quarter.msh")},
                 {"Part", "ball"},
                 {"Curved boundaries", "contact sphere 0, 0, 1"}},
                pi / 6,
                0.7,
                {{"contact", around(Point<3>(0, 0, 1), 1)},
                 {"top", at<3>(2, 1)},
                 {"symmetry_x", at<3>(0, 0)},
                 {"symmetry_y", at<3>(1, 0)}});
}



TEST_CASE("file: one of two parts")
{
  const auto both = generator<2>("file",
                                 {{"File", "two-blocks.msh"}, {"Coinciding nodes", "keep"}},
                                 stored_mesh(""))
                      ->generate();
  const auto upper =
    generator<2>("file", {{"File", "two-blocks.msh"}, {"Part", "upper"}}, stored_mesh(""))
      ->generate();
  CHECK(both.cells.size() == 7 * 3 + 5 * 2);
  CHECK(upper.cells.size() == 5 * 2);
  CHECK(upper.vertices.size() == 6 * 3);
  CHECK(both.boundaries.size() == 8);
  CHECK(upper.boundaries.size() == 4);

  Triangulation<2> triangulation;
  create(triangulation, upper);
  check_boundaries<2>(triangulation,
                      upper.boundaries,
                      {{"upper_bottom", at<2>(1, 5)},
                       {"upper_right", at<2>(0, 10)},
                       {"upper_top", at<2>(1, 10)},
                       {"upper_left", at<2>(0, 0)}});
}



namespace
{
  /// Two unit squares side by side that share nodes; the line between them is named.
  std::string
  two_squares(const std::string &more_names = "", const std::string &second = "3 2 2 2 2 3 4 5")
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" +
           std::to_string(4 + !more_names.empty()) +
           "\n1 1 \"middle\"\n1 3 \"right end\"\n2 1 \"one\"\n2 2 \"two\"\n" + more_names +
           "$EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 2 1 0\n5 1 1 0\n6 0 1 0\n"
           "$EndNodes\n$Elements\n4\n1 1 2 1 1 2 5\n2 1 2 3 2 3 4\n3 3 2 1 1 1 2 5 6\n4 " +
           second + "\n$EndElements\n";
  }
} // namespace



TEST_CASE("file: a named face between parts is a boundary of each and none of both")
{
  const TemporaryFile file(two_squares());
  const auto          names_of = [&](const std::string &part) {
    const auto mesh = generator<2>("file", {{"File", file.path}, {"Part", part}})->generate();
    std::set<std::string> names;
    for (const auto &line : mesh.faces.boundary_lines)
      names.insert(mesh.boundaries[line.boundary_id]);
    return names;
  };
  CHECK(names_of("one") == std::set<std::string>{"middle", "unnamed"});
  CHECK(names_of("two") == std::set<std::string>{"middle", "right end", "unnamed"});
  CHECK(names_of("") == std::set<std::string>{"right end", "unnamed"});
}



TEST_CASE("file: what is wrong with it is said, with its name")
{
  const auto attempt = [](const std::string &text, Keys keys = {}) {
    const TemporaryFile file(text);
    keys.push_back({"File", file.path});
    const std::string message = message_of([&] { generator<2>("file", keys)->generate(); });
    says(message, keys.size() == 1 || keys[0].first == "Part" ? file.path : keys[0].first);
    return message;
  };
  says(message_of([] {
         generator<2>("file", {{"File", "absent.msh"}});
       }),
       "absent.msh' cannot be opened");
  says(attempt("solid"), "not a mesh file");
  says(attempt("$MeshFormat\n4.1 1 8\n$EndMeshFormat\n"), "binary");
  says(attempt("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), "no elements");
  says(attempt(two_squares(), {{"Part", "three"}}), "Part = three");
  says(attempt(two_squares(), {{"Part", "three"}}), "it has one, two");
  says(attempt(two_squares("", "3 2 2 2 2 3 5 4")), "folded");
  says(attempt(two_squares("", "3 2 2 2 2 3 4 9")), "unknown node 9");
  says(attempt(two_squares("", "10 2 2 2 2 3 4 5 1 1 1 1 1")), "inverted by its mid-side nodes");
  says(attempt(two_squares("3 1 \"body\"\n", "5 2 1 1 1 2 3 4 5 6 1 2")),
       "three-dimensional cells");
  says(attempt(two_squares(), {{"Curved boundaries", "arc circle 0 0"}}), "no boundary 'arc'");
  says(attempt(two_squares(), {{"Curved boundaries", "middle sphere 0 0"}}), "NAME circle");
  says(attempt(two_squares(), {{"Curved boundaries", "middle circle 0"}}), "2 numbers");
  std::string apart = two_squares("", "3 2 1 1 7 3 4 5");
  apart.replace(apart.find("$Nodes\n6\n"), 9, "$Nodes\n7\n7 1 0 0\n");
  says(attempt(apart, {{"Part", "one"}}), "connected elsewhere are not");
  says(attempt(two_squares(), {{"Part", "two"}, {"Curved boundaries", "right end circle 0 0"}}),
       "do not lie");
}



TEST_CASE("METIS takes many coarse cells that stay as they are")
{
  MeshSettings<3> settings;
  CHECK(settings.by_p4est(30000));
  CHECK(!settings.by_p4est(30001));
  settings.refinements = 1;
  CHECK(settings.by_p4est(1000000));
  settings.distribution = Distribution::METIS;
  CHECK(!settings.by_p4est(1));
  settings              = {};
  settings.distribution = Distribution::p4est;
  CHECK(settings.by_p4est(1000000));
}
