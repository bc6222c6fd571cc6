// SPDX-License-Identifier: Apache-2.0
#include "contact/search/projection.h"

#include "contact/search/face_patch.h"

#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>

#include <doctest/doctest.h>

#include <random>

using namespace dealii;
using namespace Signorini;

namespace
{
  using Dim2 = std::integral_constant<int, 2>;
  using Dim3 = std::integral_constant<int, 3>;

  std::mt19937 random_numbers;

  double
  random_number(const double lower, const double upper)
  {
    return std::uniform_real_distribution<double>(lower, upper)(random_numbers);
  }

  template <int dim>
  Point<dim>
  random_point(const double lower, const double upper)
  {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = random_number(lower, upper);
    return p;
  }

  // The unit square (interval) in the plane x_dim = 0 with every node moved at random.
  template <int dim>
  FacePatch<dim>
  random_patch(const unsigned int k, const double bumpiness, const double outward = 1)
  {
    std::vector<Point<dim>> nodes;
    for (unsigned int n = 0; n < Utilities::pow(k + 1, dim - 1); ++n)
      {
        Point<dim> node = random_point<dim>(-bumpiness / k, bumpiness / k);
        node[0] += double(n % (k + 1)) / k;
        if (dim == 3)
          node[1] += double(n / (k + 1)) / k;
        nodes.push_back(node);
      }
    return {k, nodes, outward};
  }

  // Parameter number n of a grid with per_line points a line, border included.
  template <int n_parameters>
  Point<n_parameters>
  grid_point(unsigned int n, const unsigned int per_line)
  {
    Point<n_parameters> xi;
    for (unsigned int d = 0; d < n_parameters; ++d, n /= per_line)
      xi[d] = double(n % per_line) / (per_line - 1);
    return xi;
  }

  template <int dim>
  std::vector<Point<dim>>
  dense_sampling(const FacePatch<dim> &patch)
  {
    const unsigned int      per_line = dim == 2 ? 2001 : 61;
    std::vector<Point<dim>> positions;
    for (unsigned int n = 0; n < Utilities::pow(per_line, dim - 1); ++n)
      positions.push_back(patch.position(grid_point<dim - 1>(n, per_line)));
    return positions;
  }

  // Necessary for a minimum: no way down inside the square, only out of it.
  template <int dim>
  double
  stationarity(const Point<dim> &x, const FacePatch<dim> &patch, const Projection<dim> &result)
  {
    const auto tangents  = patch.tangents(result.xi);
    double     violation = 0;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        double slope = (result.position - x) * tangents[d] / tangents[d].norm();
        if (result.xi[d] == 0)
          slope = std::min(slope, 0.);
        if (result.xi[d] == 1)
          slope = std::max(slope, 0.);
        violation = std::max(violation, std::abs(slope));
      }
    return violation;
  }

  template <int dim>
  void
  check_against_sampling(const unsigned int k, const double bumpiness, const double height)
  {
    const FacePatch<dim>          patch   = random_patch<dim>(k, bumpiness);
    const std::vector<Point<dim>> samples = dense_sampling(patch);
    for (unsigned int n = 0; n < 50; ++n)
      {
        Point<dim> x = random_point<dim>(-0.5, 1.5); // beyond the rim as well
        x[dim - 1]   = random_number(-height, height);

        double least = 1e10;
        for (const Point<dim> &sample : samples)
          least = std::min(least, x.distance(sample));
        const Projection<dim> result = project(x, patch);

        CAPTURE(x);
        CHECK(result.distance <= least + 1e-12);
        CHECK(result.distance >= least - (dim == 2 ? 1e-2 : 5e-2));
        CHECK(result.position.distance(patch.position(result.xi)) < 1e-14);
        CHECK(result.distance == doctest::Approx(x.distance(result.position)).epsilon(1e-14));
        if (result.converged_by_newton)
          CHECK(stationarity(x, patch, result) < 1e-10);
      }
  }

  // A quadratic patch through three points of the parabola y = x^2.
  FacePatch<2>
  parabola(const double left, const double right)
  {
    std::vector<Point<2>> nodes;
    for (const double x : {left, (left + right) / 2, right})
      nodes.emplace_back(x, x * x);
    return {2, nodes, 1};
  }
} // namespace



TEST_CASE_TEMPLATE("unit_point follows QProjector", D, Dim2, Dim3)
{
  constexpr int dim = D::value;
  random_numbers.seed(42);
  const Point<dim - 1>      xi = random_point<dim - 1>(0, 1);
  const Quadrature<dim - 1> quadrature(xi);
  for (const unsigned int face : GeometryInfo<dim>::face_indices())
    {
      std::vector<Point<dim>> points(1);
      QProjector<dim>::project_to_face(ReferenceCells::get_hypercube<dim>(),
                                       quadrature,
                                       face,
                                       points);
      CHECK(points[0].distance(unit_point<dim>(ReferenceCells::get_hypercube<dim>(), face, xi)) <
            1e-15);
    }
}



TEST_CASE_TEMPLATE("derivatives of a face agree with finite differences", D, Dim2, Dim3)
{
  constexpr int dim = D::value;
  random_numbers.seed(42);
  const double h = 1e-5;
  for (unsigned int k = 1; k <= 4; ++k)
    {
      const FacePatch<dim> patch      = random_patch<dim>(k, 0.5);
      const Point<dim - 1> xi         = random_point<dim - 1>(0.1, 0.9);
      const auto           tangents   = patch.tangents(xi);
      const auto           curvatures = patch.curvatures(xi);
      for (unsigned int i = 0; i < dim - 1; ++i)
        {
          const Tensor<1, dim - 1> step = h * Point<dim - 1>::unit_vector(i);
          const Tensor<1, dim>     difference =
            (patch.position(xi + step) - patch.position(xi - step)) / (2 * h);
          CHECK((difference - tangents[i]).norm() < 1e-7);
          CHECK(std::abs(patch.normal(xi) * tangents[i]) < 1e-14);

          const auto plus = patch.tangents(xi + step), minus = patch.tangents(xi - step);
          for (unsigned int j = 0; j < dim - 1; ++j)
            CHECK(((plus[j] - minus[j]) / (2 * h) - curvatures[i][j]).norm() < 1e-6);
        }
      CHECK(patch.normal(xi).norm() == doctest::Approx(1));
    }
}



TEST_CASE_TEMPLATE("the box of a face contains it and is tight where it is flat", D, Dim2, Dim3)
{
  constexpr int dim = D::value;
  random_numbers.seed(42);
  for (unsigned int k = 1; k <= 4; ++k)
    {
      const FacePatch<dim> patch = random_patch<dim>(k, 1.5);
      for (const Point<dim> &sample : dense_sampling(patch))
        REQUIRE(patch.box().point_inside(sample, 0.));

      const FacePatch<dim> flat = random_patch<dim>(k, 0);
      for (unsigned int d = 0; d < dim; ++d)
        CHECK(flat.box().side_length(d) == doctest::Approx(d == dim - 1 ? 0 : 1).epsilon(1e-12));
      CHECK(flat.diameter() == doctest::Approx(std::sqrt(dim - 1.)));
    }
}



TEST_CASE_TEMPLATE("a face of a cell is the mapping's face, its normal points outward",
                   D,
                   Dim2,
                   Dim3)
{
  constexpr int dim = D::value;
  random_numbers.seed(42);
  Triangulation<dim> triangulation;
  GridGenerator::hyper_shell(triangulation, Point<dim>(), 0.5, 1);
  for (unsigned int k = 1; k <= 4; ++k)
    {
      const MappingQ<dim>      mapping(k);
      const FE_Nothing<dim>    fe;
      FEFaceValues<dim>        values(mapping, fe, QMidpoint<dim - 1>(), update_normal_vectors);
      const QMidpoint<dim - 1> middle;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          {
            const FacePatch<dim> patch(mapping, k, cell, face);
            const Point<dim - 1> xi = random_point<dim - 1>(0, 1);
            const Point<dim>     x  = mapping.transform_unit_to_real_cell(
              cell, unit_point<dim>(ReferenceCells::get_hypercube<dim>(), face, xi));
            CHECK(x.distance(patch.position(xi)) < 1e-13);
            values.reinit(cell, face);
            CHECK((values.normal_vector(0) - patch.normal(middle.point(0))).norm() < 1e-12);
          }
    }
}



TEST_CASE("straight segment: foot of the perpendicular, or the nearer end")
{
  const FacePatch<2> segment(1, {Point<2>(1, 1), Point<2>(3, 1)}, 1);

  const Projection<2> above = project(Point<2>(1.5, -1), segment);
  CHECK(above.position.distance(Point<2>(1.5, 1)) < 1e-14);
  CHECK(above.distance == doctest::Approx(2));
  CHECK(above.tangential_offset < 1e-14);
  CHECK(segment.normal(above.xi)[1] == doctest::Approx(-1));

  const Projection<2> beside = project(Point<2>(6, 5), segment);
  CHECK(beside.position.distance(Point<2>(3, 1)) < 1e-14);
  CHECK(beside.distance == doctest::Approx(5));
  CHECK(beside.tangential_offset == doctest::Approx(3));
  CHECK(beside.converged_by_newton);
}



TEST_CASE_TEMPLATE("projection agrees with dense sampling", D, Dim2, Dim3)
{
  random_numbers.seed(42);
  for (unsigned int k = 1; k <= 4; ++k)
    for (const double bumpiness : {0.05, 0.1, 0.2})
      for (const double height : {0.1, 2.})
        {
          CAPTURE(k);
          check_against_sampling<D::value>(k, bumpiness, height);
        }
}



TEST_CASE("projection on a short arc: distance to the circle, up to the error of interpolation")
{
  const double          radius = 2, angle = 0.1;
  std::vector<Point<2>> nodes;
  for (const double a : {-angle, 0., angle})
    nodes.emplace_back(radius * std::sin(a), radius * std::cos(a));
  const FacePatch<2> arc(2, nodes, -1);

  for (const double distance : {-0.5, -1e-3, 0., 1e-3, 0.5})
    {
      const double        a = 0.06;
      const Tensor<1, 2>  direction({std::sin(a), std::cos(a)});
      const Projection<2> result = project(Point<2>((radius + distance) * direction), arc);
      CHECK(result.distance == doctest::Approx(std::abs(distance)).epsilon(2e-5).scale(1));
      CHECK(result.position.distance(Point<2>(radius * direction)) < 1e-4);
      CHECK(arc.normal(result.xi) * direction > 1 - 1e-6);
      CHECK(result.tangential_offset < 1e-12);
      CHECK(result.converged_by_newton);
    }
}



TEST_CASE("parabola: beyond the centre of curvature there are two closest points")
{
  // y - x^2 = 0 is closest to (0, b) at x^2 = b - 1/2, the distance there is sqrt(b - 1/4).
  for (const double b : {0.501, 0.52, 0.75, 1.})
    {
      const Projection<2> result = project(Point<2>(0, b), parabola(-1, 1));
      CHECK(result.distance == doctest::Approx(std::sqrt(b - 0.25)).epsilon(1e-12));
      CHECK(std::abs(result.position[0]) == doctest::Approx(std::sqrt(b - 0.5)).epsilon(1e-10));
      if (b < 0.51) // both are nearer to the sample on the maximum between them than to any other
        CHECK_FALSE(result.converged_by_newton);
    }
}



TEST_CASE("parabola: at the centre of curvature, where the Hessian vanishes")
{
  const Projection<2> result = project(Point<2>(0, 0.5), parabola(-0.4, 0.7));
  CHECK(result.distance == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(std::abs(result.position[0]) < 1e-3);
}



TEST_CASE("a face far from the origin, and of any size, is projected on as well")
{
  for (const double scale : {1e-6, 1., 1e6})
    {
      const Tensor<1, 2>    shift({1000 * scale, -1000 * scale});
      std::vector<Point<2>> nodes;
      for (const double x : {0., 0.5, 1.})
        nodes.emplace_back(Point<2>(x, 0.2 * x * x) * scale + shift);
      const FacePatch<2>  patch(2, nodes, 1);
      const Projection<2> result = project(Point<2>(Point<2>(0.4, 0.3) * scale + shift), patch);
      const Projection<2> unit =
        project(Point<2>(0.4, 0.3), FacePatch<2>(2, {{0., 0.}, {0.5, 0.05}, {1., 0.2}}, 1));
      CHECK(result.distance == doctest::Approx(unit.distance * scale).epsilon(1e-11));
      CHECK(result.xi[0] == doctest::Approx(unit.xi[0]).epsilon(1e-10));
      CHECK(result.converged_by_newton);
    }
}
