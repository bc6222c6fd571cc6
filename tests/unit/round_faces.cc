// SPDX-License-Identifier: Apache-2.0
// Facets that stand for circles, spheres, cylinders and cones are recognised as these, others are
// not.
#include "mesh_import/reconstruction/curved_faces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "mesh_helpers.h"

using namespace Signorini;
using namespace dealii;
using namespace MeshTests;

namespace
{
  constexpr double pi = numbers::PI;

  /// Quadrilaterals between the images of a grid of m times n.
  template <typename F>
  Facets<3>
  facets_of(const unsigned int m, const unsigned int n, const F &f)
  {
    std::vector<Point<3>>    vertices;
    std::vector<CellData<2>> faces;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= m; ++i)
        vertices.push_back(f(double(i) / m, double(j) / n));
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < m; ++i)
        {
          const unsigned int first = j * (m + 1) + i;
          faces.emplace_back();
          faces.back().vertices = {first, first + 1, first + m + 1, first + m + 2};
        }
    const std::vector<bool> inserted(vertices.size(), false);
    return find_round_faces(FacetGraph<3>(faces, vertices, inserted));
  }

  Facets<2>
  facets_of(const std::vector<Point<2>> &vertices)
  {
    std::vector<CellData<1>> faces;
    for (unsigned int i = 0; i + 1 < vertices.size(); ++i)
      {
        faces.emplace_back();
        faces.back().vertices = {i, i + 1};
      }
    const std::vector<bool> inserted(vertices.size(), false);
    return find_round_faces(FacetGraph<2>(faces, vertices, inserted));
  }

  Point<2>
  on_circle(const double angle, const double radius = 2)
  {
    return {3 + radius * std::cos(angle), -1 + radius * std::sin(angle)};
  }

  /// The notes about a mesh of plane elements between two lines of points, one element thick:
  /// quadrilaterals, or triangles of second order with straight sides.
  std::vector<std::string>
  notes_about(const std::vector<Point<2>> &inner,
              const std::vector<Point<2>> &outer,
              const bool                   of_triangles,
              const Keys                  &more = {})
  {
    std::vector<Point<2>> nodes;
    std::ostringstream    elements, deck;
    deck.precision(17);
    const auto add_triangle = [&](const std::array<unsigned int, 3> &v) {
      for (const unsigned int i : v)
        elements << ", " << i + 1;
      for (unsigned int i = 0; i < 3; ++i)
        {
          nodes.push_back(nodes[v[i]] + (nodes[v[(i + 1) % 3]] - nodes[v[i]]) / 2);
          elements << ", " << nodes.size();
        }
      elements << "\n";
    };
    nodes = inner;
    nodes.insert(nodes.end(), outer.begin(), outer.end());
    const unsigned int n = inner.size();
    for (unsigned int i = 0; i + 1 < n; ++i)
      if (of_triangles)
        {
          elements << 2 * i + 1;
          add_triangle({{i, n + i, i + 1}});
          elements << 2 * i + 2;
          add_triangle({{n + i, n + i + 1, i + 1}});
        }
      else
        elements << i + 1 << ", " << i + 1 << ", " << n + i + 1 << ", " << n + i + 2 << ", "
                 << i + 2 << "\n";
    deck << "*NODE\n";
    for (unsigned int i = 0; i < nodes.size(); ++i)
      deck << i + 1 << ", " << nodes[i][0] << ", " << nodes[i][1] << "\n";
    deck << "*ELEMENT, TYPE=" << (of_triangles ? "CPE6" : "CPE4") << "\n" << elements.str();
    const TemporaryFile file(deck.str(), ".inp");
    RawSection          raw;
    raw.set_value("File", file.path, "test");
    raw.set_value("Coinciding nodes", "merge", "test");
    for (const auto &[key, value] : more)
      raw.set_value(key, value, "test");
    Section section(raw);
    auto    mesh = MeshGenerator<2>::create("file");
    mesh->declare(section);
    section.close();
    std::vector<std::string> result;
    for (const std::string &note : mesh->read_file("", ""))
      if (note.find(" facets of ") != std::string::npos)
        result.push_back(note);
    return result;
  }

  /// A quarter of a circle.
  std::vector<Point<2>>
  quarter(const double radius, const unsigned int n)
  {
    std::vector<Point<2>> result;
    for (unsigned int i = 0; i <= n; ++i)
      result.push_back(on_circle(i * pi / (2 * n), radius));
    return result;
  }

  /// The number of facets that may be meant as curved.
  template <int dim>
  unsigned int
  n_bent(const std::vector<Point<dim>>                &vertices,
         const std::vector<std::vector<unsigned int>> &nodes)
  {
    std::vector<CellData<dim - 1>> faces;
    for (const auto &face : nodes)
      {
        faces.emplace_back();
        faces.back().vertices = face;
      }
    const std::vector<bool>   inserted(vertices.size(), false);
    const std::vector<double> angles = find_bent_facets(FacetGraph<dim>(faces, vertices, inserted));
    return std::count_if(angles.begin(), angles.end(), [](const double a) { return a > 0; });
  }

  /// A ring of n sides of a regular polygon, each in m equal parts.
  unsigned int
  n_bent_of_polygon(const unsigned int n, const unsigned int m)
  {
    std::vector<Point<2>>                  vertices;
    std::vector<std::vector<unsigned int>> lines;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < m; ++j)
        {
          const Point<2> a = on_circle(2 * pi * i / n), b = on_circle(2 * pi * (i + 1) / n);
          lines.push_back({i * m + j, (i * m + j + 1) % (n * m)});
          vertices.push_back(a + (b - a) * (double(j) / m));
        }
    return n_bent(vertices, lines);
  }
} // namespace



TEST_CASE("circles are recognised, also between straight lines that they touch")
{
  std::vector<Point<2>> vertices;
  for (double x = -4; x < -0.1; x += 0.5)
    vertices.emplace_back(3 + x, 1);
  for (int i = 8; i >= 0; --i)
    vertices.push_back(on_circle(i * pi / 16));
  for (double y = 0.5; y < 4; y += 0.5)
    vertices.emplace_back(5, -1 - y);
  const Facets<2> found = facets_of(vertices);
  REQUIRE(found.round.size() == 1);
  CHECK(found.round[0].faces.size() == 8);
  CHECK(found.round[0].surface.radius == doctest::Approx(2).epsilon(1e-10));
  CHECK(found.round[0].surface.center.distance({3, -1}) < 1e-10);
  CHECK(found.round[0].sagitta == doctest::Approx(2 * (1 - std::cos(pi / 32))).epsilon(0.05));
}



TEST_CASE("what is not round keeps its facets")
{
  std::vector<Point<2>> ellipse, octagon,
    bent{{0, 0}, {1, 0}, {2, 0}, {3, 0.1}, {4, 0.2}, {5, 0.3}};
  for (unsigned int i = 0; i <= 16; ++i)
    ellipse.emplace_back(3 * std::cos(i * pi / 16), 2 * std::sin(i * pi / 16));
  for (unsigned int i = 0; i <= 6; ++i)
    octagon.push_back(on_circle(i * pi / 4));
  for (const auto &vertices : {ellipse, octagon, bent})
    CHECK(facets_of(vertices).round.empty());
  CHECK(facets_of(ellipse).sagitta[5] > 0.005);
  CHECK(facets_of(octagon).sagitta[3] == 0); // corners
  const auto saddle = facets_of(6, 6, [](const double s, const double t) {
    return Point<3>(s, t, 0.3 * (s * s - t * t));
  });
  CHECK(saddle.round.empty());
}



TEST_CASE("spheres, cylinders and cones are recognised, wherever they are")
{
  const Point<3>     center(1, 2, 3);
  const Tensor<1, 3> axis({1 / 3., 2 / 3., 2 / 3.}), first({2 / 3., 1 / 3., -2 / 3.}),
    second         = cross_product_3d(axis, first);
  const auto place = [&](const double r, const double angle, const double height) {
    return center + height * axis + r * std::cos(angle) * first + r * std::sin(angle) * second;
  };
  const auto ball = facets_of(6, 5, [&](const double s, const double t) {
    return place(2 * std::cos(t - 0.4), 1.5 * s, 2 * std::sin(t - 0.4));
  });
  REQUIRE(ball.round.size() == 1);
  CHECK(ball.round[0].faces.size() == 30);
  CHECK(ball.round[0].surface.axis.norm() == 0);
  CHECK(ball.round[0].surface.radius == doctest::Approx(2).epsilon(1e-9));
  CHECK(ball.round[0].surface.center.distance(center) < 1e-9);
  for (const double slope : {0., 0.3})
    for (const double arc : {0.5, 3., 2 * pi})
      {
        CAPTURE(slope);
        CAPTURE(arc);
        const unsigned int m     = arc > 1 ? 24 : 6;
        const auto         found = facets_of(m, 3, [&](const double s, const double t) {
          return place(2 + slope * (t - 0.5), arc * s, t - 0.5);
        });
        REQUIRE(found.round.size() == 1);
        const auto &surface = found.round[0].surface;
        CHECK(found.round[0].faces.size() == 3 * m);
        CHECK(std::abs(surface.axis * axis) == doctest::Approx(1).epsilon(1e-9));
        CHECK(std::abs(surface.slope) == doctest::Approx(slope).epsilon(1e-6));
        CHECK(surface.distance(place(2 + slope * 0.1, 0.17 * arc, 0.1)) < 1e-8);
      }
}



// In seeds of irregular triangles, which are about as wide as they are high, the components of the
// normals along the mean normal differ less than those along the axis.
TEST_CASE("a cylinder of irregular triangles is no cone")
{
  constexpr unsigned int m = 12, n = 2, up = m + 1;
  std::mt19937           engine(1);
  for (unsigned int trial = 0; trial < 20; ++trial)
    {
      std::uniform_real_distribution<double> any(-0.3, 0.3);
      std::vector<Point<3>>                  vertices;
      std::vector<CellData<2>>               faces;
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= m; ++i)
          {
            const bool   is_inside = j == 1 && i > 0 && i < m;
            const double phi       = pi / 2 * (i + (is_inside ? any(engine) : 0)) / m;
            vertices.emplace_back(std::cos(phi),
                                  std::sin(phi),
                                  0.25 * (j + (is_inside ? any(engine) : 0)));
          }
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < m; ++i)
          {
            const unsigned int v = j * up + i;
            faces.resize(faces.size() + 2);
            auto &first = faces[faces.size() - 2].vertices, &second = faces.back().vertices;
            if (any(engine) > 0)
              {
                first  = {v, v + 1, v + up};
                second = {v + 1, v + 1 + up, v + up};
              }
            else
              {
                first  = {v, v + 1, v + 1 + up};
                second = {v, v + 1 + up, v + up};
              }
          }
      const std::vector<bool> inserted(vertices.size(), false);
      const Facets<3>         found = find_round_faces(FacetGraph<3>(faces, vertices, inserted));
      REQUIRE(found.round.size() == 1);
      CHECK(found.round[0].faces.size() == faces.size());
      const FittedSurface<3> &surface = found.round[0].surface;
      CHECK(surface.slope == 0);
      CHECK(surface.radius == doctest::Approx(1).epsilon(1e-10));
      CHECK(std::abs(surface.axis[2]) == doctest::Approx(1).epsilon(1e-12));
      // The point of the axis is beside the points.
      CHECK(surface.center[2] > 0);
      CHECK(surface.center[2] < 0.5);
    }
}



TEST_CASE("facets that bend on and on may be curved, edges between planes are none")
{
  CHECK(n_bent_of_polygon(24, 1) == 24);
  CHECK(n_bent_of_polygon(24, 2) == 0); // each side is a plane
  CHECK(n_bent_of_polygon(6, 1) == 0);  // 60 degrees
  CHECK(n_bent_of_polygon(4, 3) == 0);
  CHECK(n_bent_of_polygon(1000, 1) == 0); // 0.36 degrees
  // A block with a chamfer of 30 degrees, in quadrilaterals across it and along it.
  std::vector<Point<3>>                  vertices;
  std::vector<std::vector<unsigned int>> quads;
  const std::vector<Point<2>>            outline{
    {0, 0}, {1, 0}, {2, 0}, {3, 0}, {3.5, -0.5 * std::tan(pi / 6)}};
  const unsigned int n = outline.size();
  for (unsigned int k = 0; k <= 2; ++k)
    for (const Point<2> &p : outline)
      vertices.emplace_back(p[0], p[1], k);
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int i = 0; i + 1 < n; ++i)
      quads.push_back({k * n + i, k * n + i + 1, (k + 1) * n + i, (k + 1) * n + i + 1});
  CHECK(n_bent(vertices, quads) == 0);
}



TEST_CASE("notes: surfaces that stay flat although they may be curved")
{
  // The facets of six elements in a quarter are 0.0171 from the outer circle of radius 2.
  for (const bool of_triangles : {false, true})
    {
      CAPTURE(of_triangles);
      const Keys keys  = of_triangles ? Keys{{"Cells", "as in file"}} : Keys{};
      const auto thick = notes_about(quarter(1.9, 6), quarter(2, 6), of_triangles, keys);
      REQUIRE(thick.size() == 2);
      for (const std::string &note : thick)
        says(note, "6 facets of unnamed are taken for a circle of radius ");
      const auto thin = notes_about(quarter(1.97, 6), quarter(2, 6), of_triangles, keys);
      REQUIRE(thin.size() == 2);
      const bool is_outer = thin[0].find("radius 2 ") != std::string::npos;
      says(thin[is_outer ? 0 : 1],
           "6 facets of unnamed stay flat, up to 0.017 from a circle of radius 2 about (3 -1): the "
           "cells behind are too thin; use smaller elements there, or name a circle in Curved "
           "boundaries");
      Keys none = keys;
      none.emplace_back("Curved boundaries", "none");
      CHECK(notes_about(quarter(1.97, 6), quarter(2, 6), of_triangles, none).empty());
    }
  // Sides that turn now to one side, now to the other, are no smooth curve.
  std::vector<Point<2>> zigzag, below, flat;
  for (unsigned int i = 0; i <= 12; ++i)
    {
      zigzag.emplace_back(i, 0.1 * (i * i % 7));
      flat.emplace_back(i, 2);
      below.emplace_back(i, 3);
    }
  const auto rough = notes_about(zigzag, flat, false);
  REQUIRE(rough.size() == 1);
  says(rough[0], " facets of unnamed stay flat, and meet at angles of up to ");
  says(rough[0], "use smaller elements, or name a circle in Curved boundaries");
  CHECK(notes_about(flat, below, false).empty());
}
