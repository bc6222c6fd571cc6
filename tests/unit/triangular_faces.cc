// SPDX-License-Identifier: Apache-2.0
// Faces of tetrahedra: their functions, projections, segments and pressure basis.
#include "contact/constraints/pressure_basis.h"
#include "contact/search/projection.h"
#include "contact/search/segments.h"
#include "geometry/cell_rule.h"
#include "geometry/face_functions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace dealii;
using namespace Signorini;

namespace
{
  const ReferenceCell triangle = ReferenceCells::Triangle;

  std::mt19937 random_numbers;

  double
  random_number(const double lower, const double upper)
  {
    return std::uniform_real_distribution<double>(lower, upper)(random_numbers);
  }

  // The reference triangle in the plane x_2 = 0 with every node moved at random.
  FacePatch<3>
  random_patch(const unsigned int k, const double bumpiness)
  {
    std::vector<Point<3>> nodes;
    for (const Point<2> &xi : face_lattice<3>(triangle, k))
      {
        nodes.emplace_back(xi[0], xi[1], 0);
        for (unsigned int d = 0; d < 3; ++d)
          nodes.back()[d] += random_number(-bumpiness / k, bumpiness / k);
      }
    return {k, nodes, 1};
  }

  // The unit square at a height, as n x n squares or twice as many triangles with diagonals in
  // turn.
  std::vector<FacePatch<3>>
  surface(const unsigned int n, const bool of_triangles, const double height, const double outward)
  {
    std::vector<FacePatch<3>> faces;
    const auto                at = [&](const unsigned int i, const unsigned int j) {
      return Point<3>(double(i) / n, double(j) / n, height);
    };
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const Point<3> a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
          if (!of_triangles)
            faces.emplace_back(1, std::vector<Point<3>>{a, b, c, d}, outward);
          else if ((i + j) % 2 == 0)
            {
              faces.emplace_back(1, std::vector<Point<3>>{a, b, d}, outward);
              faces.emplace_back(1, std::vector<Point<3>>{d, c, a}, outward);
            }
          else
            {
              faces.emplace_back(1, std::vector<Point<3>>{b, d, c}, outward);
              faces.emplace_back(1, std::vector<Point<3>>{a, b, c}, outward);
            }
        }
    return faces;
  }
} // namespace



TEST_CASE("functions of a triangle are one at their node and zero at the others")
{
  for (const unsigned int k : {1, 2})
    {
      const auto lattice = face_lattice<3>(triangle, k);
      for (unsigned int i = 0; i < lattice.size(); ++i)
        {
          const FaceFunctions<3> functions(triangle, k, lattice[i]);
          REQUIRE(functions.size() == lattice.size());
          for (unsigned int j = 0; j < lattice.size(); ++j)
            CHECK(std::abs(functions.value(j) - (i == j)) < 1e-15);
        }
    }
}



TEST_CASE("derivatives of triangular faces agree with finite differences")
{
  random_numbers.seed(42);
  const double h = 1e-5;
  for (const unsigned int k : {1, 2})
    {
      const FacePatch<3> patch = random_patch(k, 0.3);
      const Point<2>     xi(0.3, 0.45);
      const auto         tangents   = patch.tangents(xi);
      const auto         curvatures = patch.curvatures(xi);
      for (unsigned int i = 0; i < 2; ++i)
        {
          const Tensor<1, 2> step = h * Point<2>::unit_vector(i);
          CHECK(((patch.position(xi + step) - patch.position(xi - step)) / (2 * h) - tangents[i])
                  .norm() < 1e-9);
          const auto plus = patch.tangents(xi + step), minus = patch.tangents(xi - step);
          for (unsigned int j = 0; j < 2; ++j)
            CHECK(((plus[j] - minus[j]) / (2 * h) - curvatures[i][j]).norm() < 1e-9);
        }
    }
}



TEST_CASE("projections onto triangular faces agree with dense sampling")
{
  random_numbers.seed(42);
  for (const auto &[k, bumpiness] :
       std::vector<std::pair<unsigned int, double>>{{1, 0.2}, {2, 0.1}, {2, 0.5}, {2, 1.}})
    for (unsigned int trial = 0; trial < 20; ++trial)
      {
        const FacePatch<3>          patch  = random_patch(k, bumpiness);
        const std::vector<Point<2>> places = face_lattice<3>(triangle, 60);
        for (unsigned int n = 0; n < 20; ++n)
          {
            const Point<3> x(random_number(-0.5, 1.5),
                             random_number(-0.5, 1.5),
                             random_number(-0.7, 0.7));
            double         least = 1e10;
            for (const Point<2> &xi : places)
              {
                least = std::min(least, x.distance(patch.position(xi)));
                CHECK(patch.box().point_inside(patch.position(xi), 0.));
              }
            const Projection<3> result = project(x, patch);
            CHECK(result.distance <= least + 1e-12);
            CHECK(result.distance >= least - 5e-2);
            // Inside of the triangle, also with rounding.
            CHECK(std::min({result.xi[0], result.xi[1], 1 - result.xi[0] - result.xi[1]}) >=
                  -1e-15);
            CHECK(result.position.distance(patch.position(result.xi)) < 1e-14);
          }
      }
}



TEST_CASE("segments of triangles and quadrilaterals tile the slave, whichever the other side has")
{
  const SegmentRule<3> rule(2);
  for (const bool slave_has_triangles : {false, true})
    for (const bool master_has_triangles : {false, true})
      {
        double area = 0, moment = 0, product = 0;
        for (const auto &slave : surface(3, slave_has_triangles, 0, -1))
          for (const auto &master : surface(4, master_has_triangles, 0.1, 1))
            for (const auto &point : segment_points<3>(slave, master, rule))
              {
                const Point<3> x = slave.position(point.slave), y = master.position(point.master);
                CHECK(std::hypot(x[0] - y[0], x[1] - y[1]) < 1e-12);
                area += point.weight;
                moment += point.weight * x[0] * x[0];
                product += point.weight * x[0] * x[1];
              }
        CHECK(area == doctest::Approx(1).epsilon(1e-12));
        CHECK(moment == doctest::Approx(1. / 3).epsilon(1e-12));
        CHECK(product == doctest::Approx(1. / 4).epsilon(1e-12));
      }
}



TEST_CASE(
  "a curved triangle has as many facets as squares of its degree, with the sides of the face")
{
  random_numbers.seed(42);
  const FacetedFace<3>        face(random_patch(2, 0.1));
  std::array<unsigned int, 3> n_sides{};
  double                      area = 0;
  REQUIRE(face.facets.size() == 4);
  for (const Facet<3> &facet : face.facets)
    {
      area +=
        cross_product_3d(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0])
          .norm() /
        2;
      for (unsigned int c = 0; c < 3; ++c)
        {
          const Point<2> xi = facet.parameter_of_face(triangle, triangle.vertex<2>(c));
          CHECK(facet.corners[c].distance(face.patch.position(xi)) < 1e-14);
        }
      for (unsigned int side = 0; side < 3; ++side)
        if (const auto of_face = facet.side_of_face(triangle, side))
          ++n_sides[*of_face];
    }
  CHECK(n_sides == std::array<unsigned int, 3>{{2, 2, 2}});
  CHECK(area == doctest::Approx(0.5).epsilon(0.2));
}



TEST_CASE("the pressure on triangles of degree 2 is linear, whatever corner comes first")
{
  const auto &rule = cell_rule<2>(triangle, 4);
  for (const Basis kind : {Basis::standard, Basis::dual})
    {
      std::vector<FaceNode> nodes;
      for (const Point<2> &xi : face_lattice<3>(triangle, 2))
        {
          const Point<2> place     = isotropic_coordinates(triangle, xi);
          const bool     is_corner = xi[0] != 0.5 && xi[1] != 0.5;
          nodes.push_back({nodes.size(), {{place[0], place[1]}}, false, is_corner ? 1. / 3 : 0.});
        }
      std::vector<SparseRow> shapes;
      std::vector<double>    weights;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const FaceFunctions<3> functions(triangle, 2, rule.point(q));
          shapes.emplace_back();
          for (unsigned int i = 0; i < 6; ++i)
            shapes.back().emplace_back(i, functions.value(i));
          weights.push_back(rule.weight(q));
        }
      const PressureBasis basis(nodes, shapes, weights, 0.5, kind);
      for (unsigned int i = 0; i < 6; ++i)
        CHECK(basis.has(i) == (nodes[i].share > 0));
      // Corners are nodes 0, 2 and 5.
      const std::array<unsigned int, 6> corner{{0, 9, 1, 9, 9, 2}};
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const FaceFunctions<3> lambda(triangle, 1, rule.point(q));
          for (const auto &[node, value] : basis.at(shapes[q]))
            {
              const double linear = lambda.value(corner[node]);
              CHECK(std::abs(value - (kind == Basis::standard ? linear : 4 * linear - 1)) < 1e-12);
            }
        }
    }
}
