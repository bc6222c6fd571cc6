// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/triangle_surface.h"
#include <signorini/contact/obstacles/obstacle.h>

#include <cstdint>
#include <random>

#include "mesh_helpers.h"

using namespace dealii;
using namespace Signorini;
using namespace MeshTests;

namespace
{
  using Corners = std::array<Point<3>, 3>;

  std::string
  as_text(const std::vector<Corners> &triangles)
  {
    std::ostringstream out;
    out.precision(17);
    out << "solid test\n";
    for (const Corners &t : triangles)
      {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const Point<3> &p : t)
          out << "vertex " << p << "\n";
        out << "endloop\nendfacet\n";
      }
    out << "endsolid test\n";
    return out.str();
  }



  template <typename T>
  void
  append(std::string &bytes, const T value)
  {
    bytes.append(reinterpret_cast<const char *>(&value), sizeof(T));
  }



  /// The header begins with the word that text files begin with.
  std::string
  as_binary(const std::vector<Corners> &triangles)
  {
    std::string bytes("solid");
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const Corners &t : triangles)
      {
        for (unsigned int i = 0; i < 3; ++i)
          append(bytes, 0.f);
        for (const Point<3> &p : t)
          for (unsigned int d = 0; d < 3; ++d)
            append(bytes, static_cast<float>(p[d]));
        append(bytes, static_cast<std::uint16_t>(0));
      }
    return bytes;
  }



  /// A unit sphere of n by 2 n patches, two triangles each, one at the poles.
  std::vector<Corners>
  sphere(const unsigned int n)
  {
    const auto at = [n](const unsigned int i, const unsigned int j) {
      if (i == 0 || i == n)
        return Point<3>(0, 0, i == 0 ? 1 : -1);
      const double theta = numbers::PI * i / n, phi = numbers::PI * (j % (2 * n)) / n;
      return Point<3>(std::sin(theta) * std::cos(phi),
                      std::sin(theta) * std::sin(phi),
                      std::cos(theta));
    };
    std::vector<Corners> triangles;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < 2 * n; ++j)
        {
          if (i > 0)
            triangles.push_back({{at(i, j), at(i + 1, j), at(i, j + 1)}});
          if (i + 1 < n)
            triangles.push_back({{at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)}});
        }
    return triangles;
  }



  /// A prism between z = 0 and 1 over a polygon that vertex 0 sees all of.
  std::vector<Corners>
  prism(const std::vector<Point<2>> &polygon)
  {
    const unsigned int n  = polygon.size();
    const auto         at = [&](const unsigned int i, const double z) {
      return Point<3>(polygon[i % n][0], polygon[i % n][1], z);
    };
    std::vector<Corners> triangles;
    for (unsigned int i = 0; i < n; ++i)
      {
        triangles.push_back({{at(i, 0), at(i + 1, 0), at(i + 1, 1)}});
        triangles.push_back({{at(i, 0), at(i + 1, 1), at(i, 1)}});
      }
    for (unsigned int i = 1; i + 1 < n; ++i)
      {
        triangles.push_back({{at(0, 1), at(i, 1), at(i + 1, 1)}});
        triangles.push_back({{at(0, 0), at(i + 1, 0), at(i, 0)}});
      }
    return triangles;
  }



  Obstacle<3>
  obstacle(const TemporaryFile &file, const Keys &keys = {})
  {
    RawSection raw;
    raw.set_value("Shape", "STL", "test");
    raw.set_value("File", file.path, "test");
    for (const auto &[key, value] : keys)
      raw.set_value(key, value, "test");
    Section     section(raw);
    Obstacle<3> result;
    result.declare(section);
    section.close();
    result.shape->read_file("");
    return result;
  }



  std::vector<Point<3>>
  random_points(const unsigned int n, const double low, const double high)
  {
    std::mt19937                           engine(1);
    std::uniform_real_distribution<double> coordinate(low, high);
    std::vector<Point<3>>                  points;
    for (unsigned int i = 0; i < n; ++i)
      points.emplace_back(coordinate(engine), coordinate(engine), coordinate(engine));
    return points;
  }



  /// Signed distance from a box: negative inside.
  double
  distance_from_box(const Point<3> &x, const Point<3> &low, const Point<3> &high)
  {
    double outside = 0, inside = -std::numeric_limits<double>::max();
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double depth = std::max(low[d] - x[d], x[d] - high[d]);
        outside += std::max(depth, 0.) * std::max(depth, 0.);
        inside = std::max(inside, depth);
      }
    return outside > 0 ? std::sqrt(outside) : inside;
  }
} // namespace



TEST_CASE("STL: a sphere of triangles is a sphere, up to their sagitta")
{
  const unsigned int n       = 40;
  const double       sagitta = 1 - std::cos(numbers::PI / n / std::sqrt(2.));
  const Point<3>     center(3, 0, -1);
  for (const bool binary : {false, true})
    {
      const TemporaryFile file(binary ? as_binary(sphere(n)) : as_text(sphere(n)), ".stl");
      const auto          ball = obstacle(file, {{"Scale", "2"}, {"Offset", "3, 0, -1"}});
      for (const Point<3> &x : random_points(2000, -5, 5))
        {
          const auto         place = ball.shape->closest(x);
          const Tensor<1, 3> arm   = x - center;
          const double       exact = arm.norm() - 2;
          CHECK(place.gap > exact - 1e-6);
          CHECK(place.gap < exact + 2 * sagitta + 1e-6);
          CHECK(std::abs(place.normal.norm() - 1) < 1e-12);
          if (arm.norm() > 1)
            CHECK(place.normal * arm / arm.norm() > std::cos(2 * numbers::PI / n));
        }
    }
}



TEST_CASE("STL: distances from a cube are exact at faces, edges and vertices, inside and outside")
{
  const TemporaryFile file(
    as_text(prism({Point<2>(0, 0), Point<2>(1, 0), Point<2>(1, 1), Point<2>(0, 1)})), ".stl");
  const auto cube = obstacle(file);
  for (const Point<3> &x : random_points(5000, -1, 2))
    {
      const auto   place = cube.shape->closest(x);
      const double exact = distance_from_box(x, Point<3>(), Point<3>(1, 1, 1));
      CHECK(std::abs(place.gap - exact) < 1e-12);
      // The normal is the slope of the gap.
      CHECK(std::abs(cube.shape->closest(x + 1e-7 * place.normal).gap - place.gap - 1e-7) < 1e-12);
    }
  // On an edge and a vertex the normal is the mean of the faces'.
  const auto         normal_at = [&](const Point<3> &x) { return cube.shape->closest(x).normal; };
  const Tensor<1, 3> on_edge   = normal_at(Point<3>(1, 1, 0.3)),
                     corner    = normal_at(Point<3>(1, 1, 1));
  for (unsigned int d = 0; d < 3; ++d)
    {
      CHECK(std::abs(on_edge[d] - (d < 2 ? std::sqrt(0.5) : 0)) < 1e-12);
      CHECK(std::abs(corner[d] - std::sqrt(1. / 3)) < 1e-12);
    }
}



TEST_CASE("STL: the sign is right at a reentrant edge, where single triangles mislead")
{
  // An L from the reentrant corner, which sees all of it.
  const TemporaryFile file(as_text(prism({Point<2>(2, 0),
                                          Point<2>(2, -1),
                                          Point<2>(3, -1),
                                          Point<2>(3, 1),
                                          Point<2>(0, 1),
                                          Point<2>(0, 0)})),
                           ".stl");
  const auto          body = obstacle(file);
  // Two boxes: [0,3] x [0,1] and [2,3] x [-1,0]; outside of both, the nearer one counts.
  for (const Point<3> &x : random_points(5000, -2, 4))
    {
      const double a     = distance_from_box(x, Point<3>(0, 0, 0), Point<3>(3, 1, 1)),
                   b     = distance_from_box(x, Point<3>(2, -1, 0), Point<3>(3, 0, 1));
      const double place = body.shape->closest(x).gap;
      if (std::min(a, b) > 0)
        CHECK(std::abs(place - std::min(a, b)) < 1e-12);
      else
        CHECK(place < 1e-12);
    }
}



TEST_CASE("STL: what cannot be used is said")
{
  const auto attempt = [](const std::string &text, const Keys &keys = {}) {
    const TemporaryFile file(text, ".stl");
    return message_of([&] { obstacle(file, keys); });
  };
  const std::string cube =
    as_text(prism({Point<2>(0, 0), Point<2>(1, 0), Point<2>(1, 1), Point<2>(0, 1)}));
  CHECK(attempt(cube).empty());
  says(attempt("ply"), "is no STL file");
  says(attempt(as_binary(sphere(3)).substr(0, 300)), "no triangles");
  says(attempt("solid a\nfacet\nvertex 0 0\nendfacet\n"), "without three coordinates");
  says(attempt("solid a\nfacet\nvertex 0 0 0\nvertex 0 0 1\nendfacet\n"), "without three vertices");
  says(attempt("solid a\nendsolid a\n"), "has no triangles");
  says(attempt(cube, {{"Scale", "-1"}}), "Scale");
  std::vector<Corners> turned = sphere(3);
  std::swap(turned[0][0], turned[0][1]);
  says(attempt(as_text(turned)), "face to different sides");
}



// The unit square in the plane z = 0, its normal up, as two quadrilaterals of a deck, and a
// triangle beside it.
TEST_CASE("surface elements of mesh files are obstacles, seen from either side")
{
  const std::string deck =
    "*NODE\n1, 0, 0, 0\n2, 0.5, 0, 0\n3, 1, 0, 0\n4, 0, 1, 0\n5, 0.5, 1, 0\n6, 1, 1, 0\n"
    "7, 5, 0, 3\n8, 6, 0, 3\n9, 5, 1, 3\n"
    "*ELEMENT, TYPE=R3D4, ELSET=tool\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n"
    "*ELEMENT, TYPE=R3D3, ELSET=other\n3, 7, 8, 9\n"
    "*SURFACE, NAME=up\ntool, SPOS\n*SURFACE, NAME=down\ntool, SNEG\n";
  const TemporaryFile file(deck, ".inp");
  const Point<3>      above(0.7, 0.3, 0.25);
  for (const auto &[surface, sign] :
       {std::make_pair("up", 1.), std::make_pair("DOWN", -1.), std::make_pair("tool", 1.)})
    {
      CAPTURE(surface);
      const ObstaclePoint<3> at = obstacle(file, {{"Surface", surface}}).shape->closest(above);
      CHECK(at.gap == doctest::Approx(0.25 * sign));
      CHECK((at.normal - Tensor<1, 3>({0, 0, sign})).norm() < 1e-14);
    }
  CHECK(obstacle(file).shape->closest(Point<3>(5.2, 0.2, 4)).gap == doctest::Approx(1));
  CHECK(obstacle(file, {{"Scale", "2"}, {"Offset", "0, 0, 1"}}).shape->closest(above).gap ==
        doctest::Approx(-0.75));
  CHECK_THROWS_WITH_AS(obstacle(file, {{"Surface", "side"}}),
                       doctest::Contains("has no set 'side'"),
                       SceneError);
}



// Nodes on the unit sphere: the surface deviates from it by the sagitta of its facets. Those
// through the middles are half as long, so that their sagitta is a quarter.
TEST_CASE("surface elements of second order are divided through their nodes")
{
  for (const bool of_triangles : {true, false})
    {
      CAPTURE(of_triangles);
      // A patch about the equator, with nodes at the corners, sides and centres of n x n elements.
      const unsigned int n       = 6;
      const auto         node_at = [&](const unsigned int i, const unsigned int j) {
        return j * (2 * n + 1) + i + 1;
      };
      std::ostringstream nodes, corners, sides, centers;
      nodes.precision(17);
      for (unsigned int j = 0; j <= 2 * n; ++j)
        for (unsigned int i = 0; i <= 2 * n; ++i)
          {
            const double phi = 0.87 + 0.7 * i / n, theta = 2.27 - 0.7 * j / n;
            nodes << node_at(i, j) << ' ' << std::sin(theta) * std::cos(phi) << ' '
                  << std::sin(theta) * std::sin(phi) << ' ' << std::cos(theta) << '\n';
          }
      // The types of Gmsh: triangles 2 and 9, quadrilaterals 3, 16 (8 nodes) and 10 (9 nodes).
      unsigned int n_elements = 0;
      const auto   add        = [&](const unsigned int                      first_order,
                           const unsigned int                      second_order,
                           const std::vector<std::pair<int, int>> &places,
                           const std::pair<int, int>              &at) {
        const unsigned int n_corners = first_order + 1;
        ++n_elements;
        const auto write = [&](std::ostream      &out,
                               const unsigned int type,
                               const unsigned int size) {
          out << n_elements << ' ' << type << " 2 1 1";
          for (unsigned int k = 0; k < size; ++k)
            out << ' ' << node_at(2 * at.first + places[k].first, 2 * at.second + places[k].second);
          out << '\n';
        };
        write(corners, first_order, n_corners);
        write(sides, second_order, 2 * n_corners);
        write(centers, of_triangles ? 9 : 10, of_triangles ? 6 : 9);
      };
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          if (of_triangles)
            {
              add(2, 9, {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}}, {i, j});
              add(2, 9, {{2, 0}, {2, 2}, {0, 2}, {2, 1}, {1, 2}, {1, 1}}, {i, j});
            }
          else
            add(3,
                16,
                {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}},
                {i, j});
      const auto file_of = [&](const std::ostringstream &elements) {
        return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" +
               std::to_string((2 * n + 1) * (2 * n + 1)) + "\n" + nodes.str() +
               "$EndNodes\n$Elements\n" + std::to_string(n_elements) + "\n" + elements.str() +
               "$EndElements\n";
      };
      // The largest distance of the surface from the sphere, along the radii of its middle.
      const auto error_of = [&](const std::string &text, const unsigned int n_facets) {
        const TemporaryFile file(text, ".msh");
        const Triangles     triangles = read_mesh_surface(file.path, "");
        CHECK(triangles.corners.size() == n_facets * n_elements);
        for (const Point<3> &vertex : triangles.vertices)
          CHECK(vertex.norm() == doctest::Approx(1).epsilon(1e-14));
        const auto surface = obstacle(file);
        double     error   = 0;
        for (unsigned int k = 0; k < 1000; ++k)
          {
            const double       phi = 1.1 + 0.9 * k / 1000, theta = 1.2 + std::fmod(0.37 * k, 0.7);
            const Tensor<1, 3> ray(
              {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
            const ObstaclePoint<3> at = surface.shape->closest(Point<3>(1.1 * ray));
            CHECK(at.normal * ray > 0.98);
            error = std::max(error, at.gap - 0.1);
          }
        return error;
      };
      const double coarse = error_of(file_of(corners), of_triangles ? 1 : 2),
                   fine   = error_of(file_of(sides), of_triangles ? 4 : 6);
      CHECK(coarse > 1e-3);
      // Between the four middles of a quadrilateral a longest edge is as long as one of its sides.
      CHECK(coarse / fine == doctest::Approx(of_triangles ? 4 : 2).epsilon(0.1));
      if (!of_triangles)
        CHECK(coarse / error_of(file_of(centers), 8) == doctest::Approx(4).epsilon(0.1));
    }
}



TEST_CASE("surface elements of second order fit those of first order beside them")
{
  // A triangle of second order and a quadrilateral of first order at its long edge, in the plane
  // z = 0 but for the middle of that edge.
  const TemporaryFile file("*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0.5, 0, 0\n"
                           "5, 0.5, 0.5, 0.1\n6, 0, 0.5, 0\n7, 2, 1, 0\n8, 1, 2, 0\n"
                           "*ELEMENT, TYPE=STRI65, ELSET=tool\n1, 1, 2, 3, 4, 5, 6\n"
                           "*ELEMENT, TYPE=R3D4, ELSET=tool\n2, 2, 7, 8, 3\n",
                           ".inp");
  CHECK(read_mesh_surface(file.path, "tool").corners.size() == 4 + 3);
  const auto tool = obstacle(file);
  CHECK(tool.shape->closest(Point<3>(0.5, 0.5, 0.3)).gap == doctest::Approx(0.2));
  CHECK(tool.shape->closest(Point<3>(0.5, 0.5, 0)).gap < -0.05);
}
