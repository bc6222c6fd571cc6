// SPDX-License-Identifier: Apache-2.0
// Facets of smooth surfaces that have no name are replaced by cubic curves and patches, whose
// distance from the surface is of order four; where there are kinks, facets stay.
#include "mesh_import/reconstruction/curved_faces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

using namespace Signorini;
using namespace dealii;

namespace
{
  template <int dim>
  struct Grid
  {
    std::vector<Point<dim>>        vertices;
    std::vector<CellData<dim - 1>> faces;
    std::vector<bool>              inserted, known;

    void
    add(const std::vector<unsigned int> &nodes)
    {
      faces.emplace_back();
      faces.back().vertices = nodes;
    }

    SmoothFaces<dim>
    smooth()
    {
      inserted.resize(vertices.size(), false);
      known.resize(faces.size(), false);
      return find_smooth_faces(FacetGraph<dim>(faces, vertices, inserted), known);
    }
  };

  /// A curve from places t = 0 to 1.
  Grid<2>
  line(const unsigned int n, const bool closed, const std::function<Point<2>(double)> &f)
  {
    Grid<2> grid;
    for (unsigned int i = 0; i < n + (closed ? 0 : 1); ++i)
      grid.vertices.push_back(f(double(i) / n));
    for (unsigned int i = 0; i < n; ++i)
      grid.add({i, (i + 1) % unsigned(grid.vertices.size())});
    return grid;
  }

  Grid<3>
  sheet(const unsigned int n, const std::function<Point<3>(double, double)> &f)
  {
    Grid<3> grid;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        grid.vertices.push_back(f(double(i) / n, double(j) / n));
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int first = j * (n + 1) + i;
          grid.add({first, first + 1, first + n + 1, first + n + 2});
        }
    return grid;
  }

  /// Into triangles, and these into three quadrilaterals each, with vertices on the flat triangles.
  void
  divide(Grid<3> &grid)
  {
    std::map<std::set<unsigned int>, unsigned int> at;
    const auto middle = [&](const std::set<unsigned int> &nodes) {
      const auto [entry, is_new] = at.insert({nodes, grid.vertices.size()});
      if (is_new)
        {
          Point<3> center;
          for (const unsigned int node : nodes)
            center += grid.vertices[node] / double(nodes.size());
          grid.vertices.push_back(center);
        }
      return entry->second;
    };
    grid.inserted.assign(grid.vertices.size(), false);
    const auto quadrilaterals = std::move(grid.faces);
    grid.faces.clear();
    for (const auto &face : quadrilaterals)
      for (const unsigned int other : {1, 2})
        {
          const std::array<unsigned int, 3> v{
            {face.vertices[0], face.vertices[3], face.vertices[other]}};
          for (unsigned int i = 0; i < 3; ++i)
            grid.add({v[i],
                      middle({v[i], v[(i + 1) % 3]}),
                      middle({v[i], v[(i + 2) % 3]}),
                      middle({v[0], v[1], v[2]})});
        }
    grid.inserted.resize(grid.vertices.size(), true);
  }

  template <int dim>
  double
  largest(const SmoothFaces<dim> &smooth, const std::function<double(const Point<dim> &)> &distance)
  {
    double result = 0, back = 0;
    for (const auto &one : smooth.faces)
      {
        const CurvedFace<dim> face(one.edges);
        for (double x = 0.1; x < 1; x += dim == 2 ? 0.2 : 0.4)
          for (double y = 0.1; y < (dim == 2 ? 0.2 : 1.); y += 0.4)
            {
              Point<dim - 1> xi;
              xi[dim - 2]  = y;
              xi[0]        = x;
              const auto p = face.push_forward(xi);
              result       = std::max(result, std::abs(distance(p)));
              back         = std::max(back, face.push_forward(face.pull_back(p)).distance(p));
            }
      }
    CHECK(back < 1e-13);
    return result;
  }

  template <int dim>
  double
  uncertainty(const SmoothFaces<dim> &smooth)
  {
    double result = 0;
    for (const auto &one : smooth.faces)
      result = std::max(result, one.uncertainty);
    return result;
  }

  double
  cam(const Point<2> &p)
  {
    return p.norm() - (1 + 0.1 * std::cos(3 * std::atan2(p[1], p[0])));
  }

  Point<2>
  on_cam(const double t, const double part)
  {
    const double angle = 2 * numbers::PI * part * t;
    return (1 + 0.1 * std::cos(3 * angle)) * Point<2>(std::cos(angle), std::sin(angle));
  }

  /// A smooth function that is about the distance.
  double
  ellipsoid(const Point<3> &p)
  {
    return (p[0] * p[0] + p[1] * p[1] / 2.25 + p[2] * p[2] / 4 - 1) / 2;
  }

  Point<3>
  on_ellipsoid(const double s, const double t)
  {
    const double a = 1.2 * (s - 0.5) + 0.3, b = 1.2 * (t - 0.5);
    return {std::sin(a) * std::cos(b), 1.5 * std::sin(b), 2 * std::cos(a) * std::cos(b)};
  }
} // namespace



TEST_CASE("curves through the corners of facets have the order four")
{
  for (const bool closed : {true, false})
    {
      CAPTURE(closed);
      double last = 0;
      for (const unsigned int n : {48, 96, 192})
        {
          CAPTURE(n);
          const auto smooth =
            line(n, closed, [&](const double t) { return on_cam(t, closed ? 1 : 0.7); }).smooth();
          const double error   = largest<2>(smooth, cam),
                       sagitta = 1.9 * std::pow(2 * numbers::PI / n, 2) / 8;
          CHECK(smooth.faces.size() >= 0.7 * n);
          CHECK(error < 0.02 * sagitta);
          CHECK(error < uncertainty(smooth));
          CHECK(uncertainty(smooth) < 40 * error);
          if (last > 0)
            CHECK(error < last / 12);
          last = error;
        }
    }
}



TEST_CASE("surfaces through the corners of facets have the order four")
{
  for (const bool triangles : {false, true})
    {
      CAPTURE(triangles);
      double last = 0;
      for (const unsigned int n : {triangles ? 14u : 24u, triangles ? 28u : 48u})
        {
          CAPTURE(n);
          Grid<3> grid = sheet(n, on_ellipsoid);
          if (triangles)
            divide(grid);
          const auto   smooth = grid.smooth();
          const double error = largest<3>(smooth, ellipsoid), sagitta = std::pow(2.4 / n, 2) / 8;
          CHECK(smooth.faces.size() >= 0.9 * grid.faces.size());
          CHECK(error < 0.08 * sagitta);
          CHECK(error < uncertainty(smooth));
          CHECK(uncertainty(smooth) < 5 * error);
          // Quadrilaterals in triangles are no parallelograms: in their middle the order is two.
          if (last > 0 && triangles)
            CHECK(error < last / 4);
          else if (last > 0)
            CHECK(error < last / 15);
          if (last > 0)
            CHECK(error < (triangles ? 0.04 : 0.002) * sagitta);
          last                 = error;
          unsigned int n_moved = 0;
          for (unsigned int v = 0; v < smooth.vertices.size(); ++v)
            n_moved += !grid.inserted[v] && smooth.vertices[v] != grid.vertices[v];
          CHECK(n_moved == 0);
        }
    }
}



TEST_CASE("an edge between a plane and a smooth side stays in the plane")
{
  // A quarter of a cylinder over half an ellipse, and its lid.
  Grid<3>            grid   = sheet(12, [](const double s, const double t) {
    return Point<3>(2 * std::cos(numbers::PI / 2 * s), std::sin(numbers::PI / 2 * s), -t);
  });
  const unsigned int middle = grid.vertices.size();
  for (unsigned int i = 0; i <= 12; ++i)
    grid.vertices.emplace_back(0.5 * grid.vertices[i]);
  for (unsigned int i = 0; i < 12; ++i)
    grid.add({i, i + 1, middle + i, middle + i + 1});
  const auto smooth = grid.smooth();
  CHECK(smooth.faces.size() >= 120);
  for (const auto &one : smooth.faces)
    {
      CHECK(one.face < 144);
      if (one.face < 12)
        for (double x = 0; x <= 1; x += 0.25)
          CHECK(CurvedFace<3>(one.edges).push_forward({x, 0})[2] == doctest::Approx(0));
    }
}



TEST_CASE("kinks, corners, flat faces, and what is known stay")
{
  const auto n_smooth = [](const std::function<double(double)> &height) {
    return line(40, false, [&](const double t) { return Point<2>(t, height(t)); })
      .smooth()
      .faces.size();
  };
  for (const double kink : {0.01, 0.05, 0.2, 0.5})
    {
      CHECK(n_smooth([&](const double t) { return kink * std::abs(t - 0.5); }) == 0);
      CHECK(n_smooth([&](const double t) { return kink * std::abs(t - 0.513); }) == 0);
    }
  CHECK(n_smooth([](const double t) { return 0.3 * t * t + 0.1 * std::abs(t - 0.5); }) == 36);
  CHECK(n_smooth([](const double t) { return 0.3 * t * t; }) == 40);
  // What jitters at random is not smooth.
  unsigned int random = 1;
  CHECK(n_smooth([&](const double) {
          random = 16807 * random % 2147483647;
          return 1e-3 * random / 2147483647.;
        }) < 4);
  Grid<2> grid = line(40, false, [](const double t) { return Point<2>(t, 0.3 * t * t); });
  grid.known.assign(40, true);
  grid.known[7] = false;
  CHECK(grid.smooth().faces.empty());
}
