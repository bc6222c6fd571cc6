// SPDX-License-Identifier: Apache-2.0
#include "contact/search/segments.h"

#include "contact/interface/pairing.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace dealii;
using namespace Signorini;

namespace
{
  using Dim2 = std::integral_constant<int, 2>;
  using Dim3 = std::integral_constant<int, 3>;

  // A grid of faces over [0,1]^(dim-1) whose inner nodes are moved sideways at random, lifted by a
  // function: the surface of a body below (outward up) or above.
  template <int dim, typename Height>
  std::vector<FacePatch<dim>>
  surface(const unsigned int n,
          const unsigned int degree,
          const double       move,
          const double       outward,
          const Height      &height,
          const unsigned int seed)
  {
    std::mt19937                           random(seed);
    std::uniform_real_distribution<double> shift(-move / n, move / n);
    const unsigned int                     rows = dim == 3 ? n : 0;
    std::vector<std::array<double, 2>>     vertices;
    for (unsigned int j = 0; j <= rows; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        vertices.push_back(
          {{double(i) / n + (i > 0 && i < n ? shift(random) : 0),
            rows == 0 ? 0 : double(j) / n + (j > 0 && j < n ? shift(random) : 0)}});

    std::vector<FacePatch<dim>> faces;
    for (unsigned int j = 0; j < std::max(rows, 1u); ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          std::vector<Point<dim>> nodes;
          const auto              vertex = [&](const unsigned int a, const unsigned int b) {
            return vertices[(j + b) * (n + 1) + i + a];
          };
          for (unsigned int b = 0; b <= (dim == 3 ? degree : 0); ++b)
            for (unsigned int a = 0; a <= degree; ++a)
              {
                const double s = double(a) / degree, t = double(b) / degree;
                Point<dim>   x;
                double       flat[2];
                for (unsigned int d = 0; d < 2; ++d)
                  {
                    flat[d] = (1 - s) * vertex(0, 0)[d] + s * vertex(1, 0)[d];
                    if (dim == 3)
                      flat[d] =
                        (1 - t) * flat[d] + t * ((1 - s) * vertex(0, 1)[d] + s * vertex(1, 1)[d]);
                  }
                for (unsigned int d = 0; d < dim - 1; ++d)
                  x[d] = flat[d];
                x[dim - 1] = height(x);
                nodes.push_back(x);
              }
          // The parametric normal points down in 2D (x_xi clockwise) and up in 3D.
          faces.emplace_back(degree, nodes, dim == 2 ? -outward : outward);
        }
    return faces;
  }

  template <int dim>
  double
  area(const FacePatch<dim> &face)
  {
    const QGauss<dim - 1> rule(face.get_degree() + 4);
    double                sum = 0;
    for (unsigned int q = 0; q < rule.size(); ++q)
      sum += rule.weight(q) * face.jacobian(rule.point(q));
    return sum;
  }

  const auto flat   = [](const auto &) { return 0.; };
  const auto curved = [](const auto &x) { return 0.2 * (x[0] - x[0] * x[0]); };

  template <int dim, typename Height>
  std::vector<double>
  covered(const Height      &height,
          const unsigned int degree,
          const unsigned int n_points,
          double            &area_of_all)
  {
    const SegmentRule<dim> rule(n_points);
    const auto             slave  = surface<dim>(3, degree, 0.3, -1, height, 1);
    const auto             master = surface<dim>(4, degree, 0.3, 1, height, 2);
    std::vector<double>    errors;
    for (const auto &face : slave)
      {
        double sum = 0;
        for (const auto &other : master)
          for (const auto &point : segment_points<dim>(face, other, rule))
            sum += point.weight;
        errors.push_back(std::abs(sum / area(face) - 1));
        area_of_all += sum;
      }
    return errors;
  }
} // namespace



TEST_CASE_TEMPLATE("segments tile flat slave faces of any shape", D, Dim2, Dim3)
{
  constexpr int dim = D::value;
  double        sum = 0;
  // The Jacobian of the inverse bilinear map is smooth, not polynomial; its product with the face's
  // Jacobian is one.
  for (const double error : covered<dim>(flat, 1, 3, sum))
    CHECK(error < 1e-12);
  CHECK(sum == doctest::Approx(1).epsilon(1e-12));
}



TEST_CASE_TEMPLATE("segments tile curved slave faces, up to the error of the rule", D, Dim2, Dim3)
{
  constexpr int dim  = D::value;
  double        last = 1;
  for (const unsigned int n_points : {2, 4, 6})
    {
      double                    sum = 0, worst = 0;
      const std::vector<double> errors = covered<dim>(curved, 2, n_points, sum);
      // At the rim the master's facets, seen along the normal of the slave's, end elsewhere (1e-5).
      for (const double error : dim == 2 ? errors : std::vector<double>{errors[4]})
        worst = std::max(worst, error);
      INFO("points ", n_points, ", error ", worst);
      CHECK(worst < std::max(0.2 * last, 1e-12));
      last = worst;
    }
  CHECK(last < 1e-6);
}



TEST_CASE("the segment of two rotated squares is exact")
{
  // The unit square and the square of the same center rotated by 45 degrees meet in an octagon, of
  // area 2 (sqrt(2) - 1).
  const std::vector<Point<3>> square  = {{-.5, -.5, 0}, {.5, -.5, 0}, {-.5, .5, 0}, {.5, .5, 0}};
  const double                r       = std::sqrt(0.5);
  const std::vector<Point<3>> rotated = {{0, -r, .1}, {r, 0, .1}, {-r, 0, .1}, {0, r, .1}};
  double                      area = 0, second_moment = 0;
  for (const auto &point : segment_points<3>(FacePatch<3>(1, square, 1),
                                             FacePatch<3>(1, rotated, -1),
                                             SegmentRule<3>(3)))
    {
      const Point<3> x = FacePatch<3>(1, square, 1).position(point.slave);
      CHECK(std::abs(x[0]) + std::abs(x[1]) <= r + 1e-12);
      CHECK(FacePatch<3>(1, rotated, -1).position(point.master)[0] == doctest::Approx(x[0]));
      area += point.weight;
      second_moment += point.weight * (x[0] * x[0] + x[1] * x[1]);
    }
  CHECK(area == doctest::Approx(2 * (std::sqrt(2.) - 1)).epsilon(1e-12));
  // Regular octagon of apothem 1/2 and area A: polar moment A/2 (a^2 + s^2/12), s = 2 a tan(pi/8).
  const double side = std::tan(std::acos(-1.) / 8);
  CHECK(second_moment == doctest::Approx(area / 2 * (0.25 + side * side / 12)).epsilon(1e-12));
}



TEST_CASE("a small part of a parallelogram has three points, inside, which integrate degree 2")
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const SegmentRule<3>                   exact(3), of_degree_2(2);
  unsigned int                           n_parts = 0;
  for (unsigned int trial = 0; trial < 400; ++trial)
    {
      const auto parallelogram = [&](const double size, const double height) {
        const Point<3>     corner(number(random) - size / 2, number(random) - size / 2, height);
        const Tensor<1, 3> a = Point<3>(size, 0.3 * size * number(random), 0),
                           b = Point<3>(0.3 * size * number(random), size, 0);
        return FacePatch<3>(1, {corner, corner + a, corner + b, corner + a + b}, 1);
      };
      const FacetedFace<3> slave(parallelogram(2, 0)), master(parallelogram(0.6, 0.1));
      const auto           points = segment_points(slave, master, of_degree_2),
                 reference        = segment_points(slave, master, exact);
      double covered              = 0;
      for (const auto &point : points)
        covered += point.weight;
      if (points.empty() || covered > 0.075 * slave.patch.jacobian({0.5, 0.5}))
        continue;
      ++n_parts;
      CHECK(points.size() == 3);
      for (const auto &point : points)
        for (const auto &[face, xi] :
             {std::make_pair(&slave, point.slave), std::make_pair(&master, point.master)})
          {
            // The parameters are clamped to the faces: that of a point inside gives the point back.
            const Point<3> y = face->patch.position(xi), x = slave.patch.position(point.slave);
            CHECK(std::hypot(x[0] - y[0], x[1] - y[1]) < 1e-12);
          }
      for (unsigned int p = 0; p <= 2; ++p)
        for (unsigned int q = 0; p + q <= 2; ++q)
          {
            const auto moment = [&](const auto &list) {
              double sum = 0;
              for (const auto &point : list)
                {
                  const Point<3> x = slave.patch.position(point.slave);
                  sum += point.weight * std::pow(x[0], p) * std::pow(x[1], q);
                }
              return sum;
            };
            CHECK(std::abs(moment(points) - moment(reference)) < 1e-12);
          }
    }
  CHECK(n_parts > 100);
}



TEST_CASE_TEMPLATE("pairs by segments: every rank gets the points of its faces", D, Dim2, Dim3)
{
  constexpr int  dim  = D::value;
  const MPI_Comm comm = MPI_COMM_WORLD;
  const auto     rank = Utilities::MPI::this_mpi_process(comm),
             n        = Utilities::MPI::n_mpi_processes(comm);

  // Slave and master faces are dealt out to the ranks in different orders.
  const auto all_slave = surface<dim>(
    5, 1, 0.3, -1, [](const auto &) { return 0.01; }, 3);
  const auto                  all_master = surface<dim>(7, 1, 0.3, 1, flat, 4);
  std::vector<FacePatch<dim>> slave;
  MasterFaces<dim>            master;
  for (unsigned int i = 0; i < all_slave.size(); ++i)
    if (i % n == rank)
      slave.push_back(all_slave[i]);
  for (unsigned int i = 0; i < all_master.size(); ++i)
    if (i / 2 % n == rank)
      master.patches.push_back(all_master[i]);
  master.complete = [](unsigned int, const Point<dim - 1> &, MasterProjection<dim> &) {};

  SearchStatistics statistics;
  double           sum = 0;
  for (const auto &point :
       pair_points<dim>(slave, master, {Rule::segments, 3}, 0.1, comm, statistics).points)
    {
      const Point<dim> x = slave.at(point.face).position(point.xi);
      CHECK(point.master_point.distance == doctest::Approx(0.01));
      CHECK((x - point.master_point.position).norm() == doctest::Approx(0.01));
      CHECK(point.master_point.normal[dim - 1] == doctest::Approx(1));
      sum += point.weight;
    }
  CHECK(Utilities::MPI::sum(sum, comm) == doctest::Approx(1).epsilon(1e-12));

  // Out of reach there is nothing.
  CHECK(
    pair_points<dim>(slave, master, {Rule::segments, 3}, 0.005, comm, statistics).points.empty());
}



TEST_CASE_TEMPLATE("two layers of master faces do not count twice", D, Dim2, Dim3)
{
  constexpr int dim   = D::value;
  const auto    slave = surface<dim>(
    3, 1, 0.3, -1, [](const auto &) { return 0.01; }, 5);
  MasterFaces<dim> master;
  for (const double z : {0., -0.05})
    for (const auto &face : surface<dim>(
           4, 1, 0.3, 1, [z](const auto &) { return z; }, 6))
      master.patches.push_back(face);
  master.complete = [](unsigned int, const Point<dim - 1> &, MasterProjection<dim> &) {};
  SearchStatistics statistics;
  double           sum = 0;
  for (const auto &point :
       pair_points<dim>(slave, master, {Rule::segments, 3}, 0.1, MPI_COMM_SELF, statistics).points)
    {
      CHECK(point.master_point.distance == doctest::Approx(0.01));
      sum += point.weight;
    }
  CHECK(sum == doctest::Approx(1).epsilon(1e-12));
}



TEST_CASE_TEMPLATE("a face that hardly differs from its corners is one facet", D, Dim2, Dim3)
{
  constexpr int dim = D::value;
  // Parts of a sphere (circle) of radius 1, of size h: they deviate by h/8 of their size.
  for (const double h : {0.5, 0.1, 0.01, 0.003})
    {
      double     largest = 0;
      const auto round   = [](const auto &x) {
        double square = 0;
        for (unsigned int d = 0; d < dim - 1; ++d)
          square += x[d] * x[d];
        return std::sqrt(1 - square);
      };
      std::vector<Point<dim>> nodes;
      for (const Point<dim - 1> &xi :
           face_lattice<dim>(ReferenceCells::get_hypercube<dim - 1>(), 2))
        {
          Point<dim> x;
          for (unsigned int d = 0; d < dim - 1; ++d)
            x[d] = h * (xi[d] - 0.3);
          x[dim - 1] = round(x);
          nodes.push_back(x);
          largest = std::max(largest, x.norm());
        }
      const FacetedFace<dim> face(FacePatch<dim>(2, nodes, 1));
      CHECK(face.facets.size() == (h > 0.04 ? (1u << (dim - 1)) : 1u));
      // Its segments with a plane face that covers it have the area of the curved face.
      std::vector<Point<dim>> corners;
      for (const Point<dim - 1> &xi :
           face_lattice<dim>(ReferenceCells::get_hypercube<dim - 1>(), 1))
        {
          Point<dim> x;
          for (unsigned int d = 0; d < dim - 1; ++d)
            x[d] = 2 * h * (xi[d] - 0.5);
          x[dim - 1] = 1.1;
          corners.push_back(x);
        }
      double covered = 0;
      for (const auto &point :
           segment_points<dim>(face, FacePatch<dim>(1, corners, -1), SegmentRule<dim>(4)))
        covered += point.weight;
      CHECK(covered == doctest::Approx(area(face.patch)).epsilon(1e-9));
    }
}
