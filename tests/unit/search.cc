// SPDX-License-Identifier: Apache-2.0
#include "contact/search/search.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/distributed/tria.h>
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

  template <int dim>
  using MasterProjections = std::vector<std::optional<MasterProjection<dim>>>;

  // The completion leaves a trace by which a projection can be recognised on any rank.
  template <int dim>
  MasterFaces<dim>
  master_faces(const std::vector<FacePatch<dim>> &patches)
  {
    MasterFaces<dim> master;
    master.patches  = patches;
    master.complete = [patches](const unsigned int     i,
                                const Point<dim - 1>  &xi,
                                MasterProjection<dim> &master_point) {
      master_point.stiffness = patches[i].diameter();
      for (unsigned int d = 0; d < dim; ++d)
        master_point.rigid.emplace_back(d + 7, patches[i].position(xi)[d]);
    };
    return master;
  }

  template <int dim>
  std::vector<FacePatch<dim>>
  boundary_faces(const Triangulation<dim> &triangulation, const unsigned int degree)
  {
    const MappingQ<dim>         mapping(degree);
    std::vector<FacePatch<dim>> patches;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary())
            patches.emplace_back(mapping, degree, cell, face);
    return patches;
  }

  enum class TestShape
  {
    cube,
    ball
  };

  // Refined more towards one side, so that faces of two sizes meet.
  template <int dim>
  std::vector<FacePatch<dim>>
  surface_of(const TestShape body, const MPI_Comm comm)
  {
    parallel::distributed::Triangulation<dim> triangulation(comm);
    if (body == TestShape::cube)
      GridGenerator::hyper_cube(triangulation, -1, 1);
    else
      GridGenerator::hyper_ball(triangulation);
    triangulation.refine_global(body == TestShape::cube || dim == 2 ? 2 : 1);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center()[0] > 0.3)
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
    return boundary_faces(triangulation, body == TestShape::cube ? 1 : 2);
  }

  template <int dim>
  struct PointCloud
  {
    std::vector<Point<dim>>     points;
    std::vector<Tensor<1, dim>> normals;
  };

  // The same points in every run; each rank keeps its share. Some sit exactly above vertices and
  // edges of the mesh. Normals look more or less towards the origin.
  template <int dim>
  PointCloud<dim>
  share_of_points(const unsigned int count, const MPI_Comm comm)
  {
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    PointCloud<dim>                        cloud;
    for (unsigned int n = 0; n < count; ++n)
      {
        Point<dim>     x;
        Tensor<1, dim> normal;
        for (unsigned int d = 0; d < dim; ++d)
          {
            x[d]      = n % 3 == 0 ? std::round(4 * number(generator)) / 4 : number(generator);
            normal[d] = -x[d] + 0.3 * number(generator);
          }
        if (n % Utilities::MPI::n_mpi_processes(comm) != Utilities::MPI::this_mpi_process(comm))
          continue;
        cloud.points.push_back(x);
        cloud.normals.push_back(normal / normal.norm());
      }
    return cloud;
  }

  template <int dim>
  struct Hit
  {
    const FacePatch<dim> *face;
    Projection<dim>       projection;
    bool                  overhangs;
  };

  template <int dim>
  bool
  smaller_center(const FacePatch<dim> &a, const FacePatch<dim> &b)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(a.center()[d] - b.center()[d]) > 1e-9)
        return a.center()[d] < b.center()[d];
    return false;
  }

  // The rules of find_master_projections once more, with all faces at hand and no tree.
  template <int dim>
  std::optional<Hit<dim>>
  brute_force(const Point<dim>                  &x,
              const Tensor<1, dim>              &normal,
              const std::vector<FacePatch<dim>> &faces,
              const double                       search_radius)
  {
    std::vector<Hit<dim>> hits;
    double                least = search_radius;
    for (const FacePatch<dim> &face : faces)
      {
        const Projection<dim> p = project(x, face);
        if (p.distance > search_radius || face.normal(p.xi) * normal >= -0.1)
          continue;
        const double height = std::sqrt(
          std::max(0., p.distance * p.distance - p.tangential_offset * p.tangential_offset));
        const bool above =
          p.tangential_offset <= 1e-6 * face.diameter() || p.tangential_offset <= 0.3 * height;
        hits.push_back({&face, p, !above});
        least = std::min(least, p.distance);
      }

    std::optional<Hit<dim>> best;
    for (const Hit<dim> &hit : hits)
      if (hit.projection.distance <= least + 1e-9 * hit.face->diameter())
        if (!best || hit.overhangs < best->overhangs ||
            (hit.overhangs == best->overhangs && smaller_center(*hit.face, *best->face)))
          best = hit;
    return best && !best->overhangs ? best : std::nullopt;
  }

  template <int dim>
  void
  check_master_projection(const MasterProjection<dim> &master_point, const Hit<dim> &hit)
  {
    CHECK(master_point.face_center.distance(hit.face->center()) < 1e-12);
    CHECK(master_point.position.distance(hit.projection.position) < 1e-12);
    CHECK(master_point.distance == doctest::Approx(hit.projection.distance).epsilon(1e-12));
    CHECK((master_point.normal - hit.face->normal(hit.projection.xi)).norm() < 1e-10);
    CHECK(master_point.stiffness == doctest::Approx(hit.face->diameter()));
    CHECK(master_point.rigid.size() == dim); // not REQUIRE: the others would wait for this rank
    for (unsigned int d = 0; d < master_point.rigid.size(); ++d)
      {
        CHECK(master_point.rigid[d].first == d + 7);
        CHECK(master_point.rigid[d].second == doctest::Approx(master_point.position[d]));
      }
  }

  // One face for rank `owner`, none for the others.
  template <int dim>
  std::vector<FacePatch<dim>>
  only_on(const unsigned int owner, const std::vector<FacePatch<dim>> &faces)
  {
    const unsigned int n = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == owner % n ?
             faces :
             std::vector<FacePatch<dim>>();
  }

  // The boundary y = height between two abscissae; the body is below (or above).
  FacePatch<2>
  floor_face(const double left,
             const double right,
             const double height  = 0,
             const bool   upwards = true)
  {
    return {1, {Point<2>(left, height), Point<2>(right, height)}, upwards ? -1. : 1.};
  }

  // The projection of one point that looks down, asked for by rank 0 (every rank has the answer).
  std::optional<MasterProjection<2>>
  master_projection_below(const Point<2>                  &point,
                          const std::vector<FacePatch<2>> &faces,
                          const double                     search_radius = 1)
  {
    std::vector<Point<2>>     points;
    std::vector<Tensor<1, 2>> normals;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        points  = {point};
        normals = {-1. * Point<2>::unit_vector(1)};
      }
    auto master_points =
      find_master_projections(points, normals, master_faces(faces), search_radius, MPI_COMM_WORLD);

    std::vector<MasterProjection<2>> answer;
    for (const auto &master_point : master_points)
      if (master_point)
        answer.push_back(*master_point);
    answer = Utilities::MPI::broadcast(MPI_COMM_WORLD, answer);
    return answer.empty() ? std::optional<MasterProjection<2>>() : answer[0];
  }
} // namespace



TEST_CASE_TEMPLATE("find_partners agrees with brute force on a serial copy", D, Dim2, Dim3)
{
  constexpr int dim = D::value;
  for (const TestShape body : {TestShape::cube, TestShape::ball})
    for (const double search_radius : {0.05, 0.4, 3.})
      {
        const PointCloud<dim> cloud    = share_of_points<dim>(400, MPI_COMM_WORLD);
        const auto            master   = master_faces(surface_of<dim>(body, MPI_COMM_WORLD));
        const auto            everyone = surface_of<dim>(body, MPI_COMM_SELF);
        CHECK(Utilities::MPI::sum(master.patches.size(), MPI_COMM_WORLD) == everyone.size());

        SearchStatistics             statistics;
        const MasterProjections<dim> master_points = find_master_projections(
          cloud.points, cloud.normals, master, search_radius, MPI_COMM_WORLD, &statistics);
        CHECK(statistics.points == cloud.points.size());

        unsigned int found = 0;
        for (unsigned int i = 0; i < cloud.points.size(); ++i)
          {
            const auto hit =
              brute_force(cloud.points[i], cloud.normals[i], everyone, search_radius);
            CAPTURE(cloud.points[i]);
            CHECK(hit.has_value() == master_points[i].has_value());
            if (hit && master_points[i])
              {
                check_master_projection(*master_points[i], *hit);
                ++found;
              }
          }
        CHECK(Utilities::MPI::sum(found, MPI_COMM_WORLD) > 5);
      }
}



TEST_CASE("the tree spares most projections")
{
  const PointCloud<3> cloud  = share_of_points<3>(400, MPI_COMM_WORLD);
  const auto          master = master_faces(surface_of<3>(TestShape::ball, MPI_COMM_WORLD));
  SearchStatistics    statistics;
  find_master_projections(cloud.points, cloud.normals, master, 0.2, MPI_COMM_WORLD, &statistics);
  const unsigned long faces = Utilities::MPI::sum(master.patches.size(), MPI_COMM_WORLD);
  CHECK(Utilities::MPI::sum(statistics.projections, MPI_COMM_WORLD) < 400 * faces / 20);
}



TEST_CASE("faces on one rank, the point on another; signs of gap and interference")
{
  for (const unsigned int owner : {0u, 1u, 3u})
    for (const double height : {0.2, 0., -0.2})
      {
        const auto master_point =
          master_projection_below(Point<2>(0.3, height), only_on<2>(owner, {floor_face(0, 1)}));
        REQUIRE(master_point);
        CHECK(master_point->distance == doctest::Approx(std::abs(height)));
        CHECK((Point<2>(0.3, height) - master_point->position) * master_point->normal ==
              doctest::Approx(height));
        CHECK(master_point->normal[1] == doctest::Approx(1));
        CHECK(master_point->rigid.size() == 2);
      }
}



TEST_CASE("no master at all")
{
  CHECK_FALSE(master_projection_below(Point<2>(0, 0), {}));
}



TEST_CASE("a tie goes to the smaller center, wherever the faces live")
{
  const std::vector<FacePatch<2>> left = {floor_face(0, 1)}, right = {floor_face(1, 2)};
  for (const unsigned int owner : {0u, 1u, 2u})
    for (const double height : {0.3, 0., -0.3})
      {
        std::vector<FacePatch<2>> faces = only_on(owner, right);
        for (const FacePatch<2> &face : only_on(owner + 1, left))
          faces.push_back(face);
        const auto master_point = master_projection_below(Point<2>(1, height), faces);
        REQUIRE(master_point);
        CHECK(master_point->face_center[0] == doctest::Approx(0.5));
      }
}



TEST_CASE("beside the rim there is no partner, on it there is")
{
  const auto faces = only_on<2>(1, {floor_face(0, 1)});
  CHECK(master_projection_below(Point<2>(1 + 1e-9, 0), faces));
  CHECK(master_projection_below(Point<2>(1 + 1e-9, 0.1), faces));
  CHECK(
    master_projection_below(Point<2>(1.02, 0.1), faces)); // within the wedge of a faceted surface
  CHECK_FALSE(master_projection_below(Point<2>(1.05, 0.1), faces));
  CHECK_FALSE(master_projection_below(Point<2>(1.01, 0), faces));
  CHECK_FALSE(master_projection_below(Point<2>(1.05, -0.1), faces));
}



TEST_CASE("a nearer face that is overhung hides what lies farther behind")
{
  const auto step = floor_face(0, 1, 0), ground = floor_face(0, 3, -0.5);
  CHECK_FALSE(master_projection_below(Point<2>(1.2, 0.1), only_on<2>(1, {step, ground})));
  std::vector<FacePatch<2>> apart = only_on<2>(0, {step});
  for (const FacePatch<2> &face : only_on<2>(1, {ground}))
    apart.push_back(face);
  CHECK_FALSE(master_projection_below(Point<2>(1.2, 0.1), apart));
  CHECK(master_projection_below(Point<2>(2, 0.1), apart));
}



TEST_CASE("over a convex edge one of the two faces takes the point")
{
  const FacePatch<2> flat = floor_face(0, 1);
  const FacePatch<2> slope(1, {Point<2>(1, 0), Point<2>(2, -0.4)}, -1);
  for (const double x : {1.001, 1.02, 1.03, 1.035})
    for (const unsigned int owner : {0u, 1u})
      {
        std::vector<FacePatch<2>> faces = only_on<2>(owner, {flat});
        for (const FacePatch<2> &face : only_on<2>(owner + 1, {slope}))
          faces.push_back(face);
        const auto master_point = master_projection_below(Point<2>(x, 0.1), faces);
        REQUIRE(master_point);
        CHECK(master_point->position.distance(Point<2>(1, 0)) < 1e-12);
      }
}



TEST_CASE("faces that look away neither win nor hide others")
{
  const auto near = floor_face(0, 1, 0.05, false), far = floor_face(0, 1, -0.3);
  const auto master_point = master_projection_below(Point<2>(0.5, 0.1), only_on<2>(1, {near, far}));
  REQUIRE(master_point);
  CHECK(master_point->distance == doctest::Approx(0.4));
  CHECK_FALSE(master_projection_below(Point<2>(0.5, 0.1), only_on<2>(1, {near})));
}



TEST_CASE("the reach is respected")
{
  const auto faces = only_on<2>(1, {floor_face(0, 1)});
  CHECK(master_projection_below(Point<2>(0.5, 0.1), faces, 0.11));
  CHECK_FALSE(master_projection_below(Point<2>(0.5, 0.1), faces, 0.09));
}
