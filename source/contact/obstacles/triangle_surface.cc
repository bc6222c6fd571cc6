// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/triangle_surface.h"

#include "geometry/extent.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Vector = Tensor<1, 3>;

    /// The unit vector of a direction.
    Vector
    unit(const Vector &v)
    {
      return v / v.norm();
    }



    /// A point for messages.
    std::string
    text_of(const Point<3> &p)
    {
      std::ostringstream out;
      out << '(' << p << ')';
      return out.str();
    }



    /// The angle between two vectors, accurate for small angles too.
    double
    angle_between(const Vector &a, const Vector &b)
    {
      return std::atan2(cross_product_3d(a, b).norm(), a * b);
    }
  } // namespace



  // Triangles without area are left out. The box of each triangle is an entry of an R-tree.
  TriangleSurface::TriangleSurface(const Triangles &triangles)
    : vertices(triangles.vertices)
  {
    for (const auto &t : triangles.corners)
      {
        const Vector a = vertices[t[1]] - vertices[t[0]], b = vertices[t[2]] - vertices[t[0]],
                     normal = cross_product_3d(a, b);
        if (normal.norm() <= 1e-12 * a.norm() * b.norm())
          continue;
        corners.push_back(t);
        face_normals.push_back(unit(normal));
      }
    if (corners.empty())
      throw SceneError("has no triangles");
    box = BoundingBox<3>(vertices);
    add_vertex_normals();
    add_edge_normals();

    std::vector<Entry> entries;
    for (unsigned int t = 0; t < corners.size(); ++t)
      entries.emplace_back(BoundingBox<3>(std::vector<Point<3>>{vertices[corners[t][0]],
                                                                vertices[corners[t][1]],
                                                                vertices[corners[t][2]]}),
                           t);
    tree = pack_rtree(entries);
  }



  // Pseudonormals at vertices: sums of the triangles' normals, weighted with their angles there
  // (Baerentzen, Aanaes 2005).
  void
  TriangleSurface::add_vertex_normals()
  {
    vertex_normals.resize(vertices.size());
    for (unsigned int t = 0; t < corners.size(); ++t)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Point<3> &p = vertices[corners[t][i]], &q = vertices[corners[t][(i + 1) % 3]],
                         &r = vertices[corners[t][(i + 2) % 3]];
          vertex_normals[corners[t][i]] += angle_between(q - p, r - p) * face_normals[t];
        }
  }



  // Pseudonormals at edges: sums of the normals of both triangles. A consistently oriented surface
  // traverses each edge once in each direction; anything else is an error of the input.
  void
  TriangleSurface::add_edge_normals()
  {
    using Edge = std::pair<unsigned int, unsigned int>;
    std::map<Edge, unsigned int> triangle_of; // of each edge, in its direction
    const auto                   edge_of = [&](const unsigned int t, const unsigned int i) {
      return Edge(corners[t][i], corners[t][(i + 1) % 3]);
    };
    for (unsigned int t = 0; t < corners.size(); ++t)
      for (unsigned int i = 0; i < 3; ++i)
        if (!triangle_of.insert({edge_of(t, i), t}).second)
          throw SceneError("has triangles at " + text_of(vertices[corners[t][i]]) +
                           " that face to different sides, or more than two at one edge; repair "
                           "the surface there");

    edge_normals.resize(corners.size());
    for (unsigned int t = 0; t < corners.size(); ++t)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Edge edge    = edge_of(t, i);
          const auto other   = triangle_of.find({edge.second, edge.first});
          edge_normals[t][i] = face_normals[t];
          if (other != triangle_of.end())
            edge_normals[t][i] += face_normals[other->second];
        }
  }



  // Closest point of a triangle by the regions of its vertices, edges and interior (Ericson,
  // Real-Time Collision Detection, 5.1.5).
  TriangleSurface::TrianglePoint
  TriangleSurface::foot(const Point<3> &x, const unsigned int triangle) const
  {
    const auto     &c = corners[triangle];
    const Point<3> &p = vertices[c[0]], &q = vertices[c[1]], &r = vertices[c[2]];
    const Vector    a = q - p, b = r - p;
    // The signs of the products of the edges a, b with the arms from the corners tell in whose
    // region x lies: of a corner if both are beyond it, of an edge if x is outside of the triangle
    // there.
    const double ap = a * (x - p), bp = b * (x - p), aq = a * (x - q), bq = b * (x - q),
                 ar = a * (x - r), br = b * (x - r);
    const auto at_vertex = [&](const unsigned int i) {
      return TrianglePoint{vertices[c[i]], vertex_normals[c[i]], false};
    };
    const auto on_edge = [&](const unsigned int i, const double s) {
      const Point<3> &from = vertices[c[i]], &to = vertices[c[(i + 1) % 3]];
      return TrianglePoint{from + s * (to - from), edge_normals[triangle][i], false};
    };

    if (ap <= 0 && bp <= 0)
      return at_vertex(0);
    if (aq >= 0 && bq <= aq)
      return at_vertex(1);
    const double of_r = ap * bq - aq * bp;
    if (of_r <= 0 && ap >= 0 && aq <= 0)
      return on_edge(0, ap / (ap - aq));
    if (br >= 0 && ar <= br)
      return at_vertex(2);
    const double of_q = ar * bp - ap * br;
    if (of_q <= 0 && bp >= 0 && br <= 0)
      return on_edge(2, 1 - bp / (bp - br));
    const double of_p = aq * br - ar * bq;
    if (of_p <= 0 && bq >= aq && ar >= br)
      return on_edge(1, (bq - aq) / ((bq - aq) + (ar - br)));
    const double sum = of_p + of_q + of_r;
    return {p + (of_q / sum) * a + (of_r / sum) * b, face_normals[triangle], true};
  }



  // Signed distance: the nearest boxes of the tree are examined, four times as many in each round,
  // until the farthest of them is beyond the closest point found. The sign is that of the
  // pseudonormal there.
  ObstaclePoint<3>
  TriangleSurface::closest(const Point<3> &x) const
  {
    namespace bgi = boost::geometry::index;
    TrianglePoint best;
    double        smallest = std::numeric_limits<double>::max();
    // Examine the boxes nearest to x, more in each round, until the others are farther away than
    // the closest point.
    for (std::size_t n = 8, seen = 0; seen < tree.size(); n *= 4)
      {
        double             farthest = 0;
        std::vector<Entry> entries;
        tree.query(bgi::nearest(x, n), std::back_inserter(entries));
        for (const Entry &entry : entries)
          {
            farthest                   = std::max(farthest, distance(x, entry.first));
            const TrianglePoint other  = foot(x, entry.second);
            const double        so_far = x.distance(other.point);
            if (so_far < smallest)
              {
                smallest = so_far;
                best     = other;
              }
          }
        seen = farthest > smallest ? tree.size() : entries.size();
      }
    const Vector arm = x - best.point;
    // With pseudonormals the sign is right also where the closest point is a corner or an edge; the
    // normal of one of the triangles there may give the wrong one.
    const double sign = arm * best.normal < 0 ? -1 : 1;
    if (best.inside)
      return {arm * best.normal, best.normal};
    // On the surface itself the direction from the closest point is rounding; the pseudonormal
    // replaces it.
    const bool touches =
      smallest < 1e-10 * box.get_boundary_points().first.distance(box.get_boundary_points().second);
    return {sign * smallest, touches ? unit(best.normal) : sign * arm / smallest};
  }
} // namespace Signorini
