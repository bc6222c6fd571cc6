// SPDX-License-Identifier: Apache-2.0
// Facets that stand for circles, spheres, cylinders and cones are recognised as these, others are
// not.
#include "mesh_import/reconstruction/curved_faces.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace Signorini;
using namespace dealii;

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
