// SPDX-License-Identifier: Apache-2.0
#include "contact/search/segments.h"

#include "geometry/cell_rule.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A facet in a plane.
    template <int n>
    struct Flat
    {
      std::array<Point<n>, (1 << n)> corners; ///< of triangles the first three
      bool                           is_triangle;

      const Point<n> &
      operator[](const unsigned int c) const
      {
        return corners[c];
      }
    };

    /// The corners of a facet projected along the normal of another one, in the coordinates of its
    /// plane.
    /// In the coordinates of the plane along its axes, with the centre of the facet as origin: all
    /// further computations are with differences of nearby points, also far from the origin of the
    /// model.
    template <int dim>
    Flat<dim - 1>
    project(const Facet<dim> &facet, const Facet<dim> &plane)
    {
      Flat<dim - 1> flat{{}, facet.corners.size() == 3};
      for (unsigned int c = 0; c < facet.corners.size(); ++c)
        for (unsigned int d = 0; d < dim - 1; ++d)
          flat.corners[c][d] = (facet.corners[c] - plane.center) * plane.axes[d];
      return flat;
    }

    /// The term of a flat facet with the product of both parameters, which triangles do not have.
    Tensor<1, 2>
    warp_of(const Flat<2> &x)
    {
      return x.is_triangle ? Tensor<1, 2>() : (x[3] - x[2]) - (x[1] - x[0]);
    }

    /// The parameter of a point of a flat facet, and the Jacobian |dx/ds| there. Newton's method
    /// from the middle; one step suffices for triangles and parallelograms; ends after at most 30
    /// steps.
    template <int n>
    std::pair<Point<n>, double>
    invert(const Flat<n> &x, const Point<n> &y)
    {
      Point<n> s;
      double   jacobian = 0;
      if constexpr (n == 1)
        {
          jacobian = x[1][0] - x[0][0];
          s[0]     = (y[0] - x[0][0]) / jacobian;
        }
      else
        {
          s = Point<n>(0.5, 0.5);
          // x(s) = x0 + s0 edge + s1 other + s0 s1 warp. The Jacobian matrix has the columns a and
          // b; its inverse is written by Cramer's rule.
          const Tensor<1, n> edge = x[1] - x[0], other = x[2] - x[0], warp = warp_of(x);
          for (unsigned int step = 0; step < 30; ++step)
            {
              const Tensor<1, n> a = edge + s[1] * warp, b = other + s[0] * warp,
                                 r = (y - x[0]) - s[0] * edge - s[1] * other - s[0] * s[1] * warp;
              jacobian             = a[0] * b[1] - a[1] * b[0];
              const Tensor<1, n> step_to(
                {(r[0] * b[1] - r[1] * b[0]) / jacobian, (a[0] * r[1] - a[1] * r[0]) / jacobian});
              s += step_to;
              if (step_to.norm() < 1e-14)
                break;
            }
        }
      return {s, std::abs(jacobian)};
    }

    /// The vector product in the plane.
    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    // The number of a polygon side that is no side of the clipped facet.
    constexpr int none = -1;

    /// A corner of a polygon, and the number of the side of the facet that begins there.
    struct Corner
    {
      Point<2> x;
      int      side;
    };

    using Polygon = std::vector<Corner>;

    /// The area of a polygon, positive if its corners go around counterclockwise.
    double
    signed_area(const Polygon &p)
    {
      double area = 0;
      // The sum over the triangles of the first corner and each side; with corners relative to the
      // first one nothing cancels far from the origin.
      for (std::size_t i = 0; i + 1 < p.size(); ++i)
        area += cross(p[i].x - p[0].x, p[i + 1].x - p[0].x) / 2;
      return area;
    }

    /// The corners of a facet as a counterclockwise polygon, with their sides, numbered as in
    /// ends_of_side().
    Polygon
    counterclockwise(const Flat<2> &x)
    {
      // Around the facet: from corner 0 along the side s1 = 0 (number 2), then s0 = 1 (1), s1 = 1
      // (3) and s0 = 0 (0). A facet that is seen from its other side has a clockwise projection,
      // and its order is reversed.
      Polygon p = x.is_triangle ? Polygon{{x[0], 0}, {x[1], 1}, {x[2], 2}} :
                                  Polygon{{x[0], 2}, {x[1], 1}, {x[3], 3}, {x[2], 0}};
      if (signed_area(p) < 0 && x.is_triangle)
        p = {{x[2], 1}, {x[1], 0}, {x[0], 2}};
      else if (signed_area(p) < 0)
        p = {{x[2], 3}, {x[3], 1}, {x[1], 2}, {x[0], 0}};
      return p;
    }

    /// Clip a polygon by a convex window with counterclockwise corners (Sutherland, Hodgman 1974):
    /// for each edge of the window in turn, the part to the left of it is kept. Sides that stem
    /// from the polygon keep their numbers, those from the window get `none`. The result is convex
    /// if the polygon is.
    Polygon
    clip(Polygon polygon, const Polygon &window)
    {
      for (std::size_t i = 0; i < window.size() && !polygon.empty(); ++i)
        {
          const Point<2>    &start = window[i].x;
          const Tensor<1, 2> edge  = window[(i + 1) % window.size()].x - start;
          Polygon            kept;
          for (std::size_t j = 0; j < polygon.size(); ++j)
            {
              const auto &[a, side]  = polygon[j];
              const Point<2> &b      = polygon[(j + 1) % polygon.size()].x;
              const double    left_a = cross(edge, a - start), left_b = cross(edge, b - start);
              // A corner on the edge itself is kept. If the polygon leaves the window there, the
              // side that begins at it is part of the window from now on.
              if (left_a >= 0)
                kept.push_back({a, left_a == 0 && left_b < 0 ? none : side});
              if ((left_a > 0 && left_b < 0) || (left_a < 0 && left_b > 0))
                kept.push_back(
                  {a + left_a / (left_a - left_b) * (b - a), left_b < 0 ? none : side});
            }
          polygon = std::move(kept);
        }
      return polygon;
    }

    /// Points with weights [length^(dim-1)] in the plane of a facet.
    template <int n>
    using FlatPoints = std::vector<std::pair<Point<n>, double>>;

    /// Quadrature points of the common part of two facets in the line.
    FlatPoints<1>
    common_points(const Flat<1> &a,
                  const Flat<1> &b,
                  const unsigned int /*n_facets*/,
                  const SegmentRule<2> &rule)
    {
      // The interval of one facet in the line of the other, whatever the direction of its parameter
      // is.
      const double lower = std::max(std::min(a[0][0], a[1][0]), std::min(b[0][0], b[1][0])),
                   upper = std::min(std::max(a[0][0], a[1][0]), std::max(b[0][0], b[1][0]));
      if (lower >= upper)
        return {};
      FlatPoints<1> result;
      for (unsigned int q = 0; q < rule.on_simplices.size(); ++q)
        result.emplace_back(Point<1>(lower + rule.on_simplices.point(q)[0] * (upper - lower)),
                            rule.on_simplices.weight(q) * (upper - lower));
      return result;
    }

    /// True if the bounding boxes of two flat facets are disjoint: a cheap test before clipping.
    bool
    apart(const Flat<2> &a, const Flat<2> &b)
    {
      const auto extent = [](const Flat<2> &x, const unsigned int d) {
        // Of a triangle the last corner is taken twice.
        return std::minmax({x[0][d], x[1][d], x[2][d], x[x.is_triangle ? 2 : 3][d]});
      };
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto [a0, a1] = extent(a, d);
          const auto [b0, b1] = extent(b, d);
          if (a1 < b0 || b1 < a0)
            return true;
        }
      return false;
    }

    /// Append the points of a rule on a flat triangle or quadrilateral.
    void
    append(const Quadrature<2> &rule, const Flat<2> &x, FlatPoints<2> &points)
    {
      const Tensor<1, 2> edge = x[1] - x[0], other = x[2] - x[0], warp = warp_of(x);
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const Point<2> &s = rule.point(q);
          points.emplace_back(x[0] + s[0] * edge + s[1] * other + s[0] * s[1] * warp,
                              rule.weight(q) * cross(edge + s[1] * warp, other + s[0] * warp));
        }
    }

    /// Points of a convex polygon, cut into quadrilaterals and, if the number of corners is odd, a
    /// triangle around its first corner. A polynomial of degree k is one of degree k in each
    /// parameter of a quadrilateral, and its Jacobian one of degree 1.
    FlatPoints<2>
    points_of_pieces(const Polygon &p, const SegmentRule<3> &rule)
    {
      FlatPoints<2> result;
      std::size_t   i = 1;
      for (; i + 2 < p.size(); i += 2)
        append(rule.on_squares, {{{p[0].x, p[i].x, p[i + 2].x, p[i + 1].x}}, false}, result);
      if (i + 1 < p.size())
        append(rule.on_simplices, {{{p[0].x, p[i].x, p[i + 1].x, {}}}, true}, result);
      return result;
    }

    /// Three points of a convex polygon with equal weights that have its area, centre and second
    /// moments, so that they integrate polynomials of degree 2 exactly: c + L r_i with L L^T the
    /// second moments about the centre c over the area, and r_i the corners of an equilateral
    /// triangle on the circle of radius sqrt(2). They are inside: a convex set whose second moments
    /// are the unit matrix contains the disc of that radius about its centre (R. Kannan, L. Lovász,
    /// M. Simonovits: Isoperimetric problems for convex bodies and a localization lemma, Discrete &
    /// Computational Geometry 13 (1995) 541, theorem 4.1).
    FlatPoints<2>
    points_of_degree_2(const Polygon &p)
    {
      // Integrals of 1, x and x x^T over the triangles, relative to the first corner.
      double       area = 0;
      Tensor<1, 2> first;
      Tensor<2, 2> second;
      for (std::size_t i = 1; i + 1 < p.size(); ++i)
        {
          const Tensor<1, 2> a = p[i].x - p[0].x, b = p[i + 1].x - p[0].x;
          const double       part = cross(a, b) / 2;
          area += part;
          first += part / 3 * (a + b);
          second +=
            part / 12 * (outer_product(a, a) + outer_product(b, b) + outer_product(a + b, a + b));
        }
      if (!(area > 0))
        return {};
      const Tensor<1, 2> center = first / area;
      const Tensor<2, 2> about  = second / area - outer_product(center, center);
      // The Cholesky factor. The lengths of slivers may be of the size of rounding.
      const double l_00 = std::sqrt(std::max(about[0][0], 0.)),
                   l_10 = l_00 > 0 ? about[1][0] / l_00 : 0.,
                   l_11 = std::sqrt(std::max(about[1][1] - l_10 * l_10, 0.));
      FlatPoints<2> result;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double angle = 2 * numbers::PI / 3 * i, x = numbers::SQRT2 * std::cos(angle),
                       y = numbers::SQRT2 * std::sin(angle);
          result.emplace_back(p[0].x + center + Tensor<1, 2>({l_00 * x, l_10 * x + l_11 * y}),
                              area / 3);
        }
      return result;
    }

    /// @return whether a flat facet is a triangle, or a parallelogram up to a twentieth of its
    /// diagonal: its functions are then polynomials of degree 1 or 2 in the plane, which those of
    /// others are not.
    bool
    has_polynomials(const Flat<2> &x)
    {
      constexpr double most = 0.05;
      return warp_of(x).norm() < most * (x[x.is_triangle ? 2 : 3] - x[0]).norm();
    }

    /// Quadrature points of the common part of two flat facets. With a rule of degree 2 a part of
    /// two triangles, whose linear functions have products of degree 2, has three points, whatever
    /// its shape is; also one with a parallelogram if it is smaller than a twelfth of the slave
    /// face. Others have those of the rule in quadrilaterals and triangles. In larger parts the
    /// terms of degree 3 and 4 of products of two bilinear functions count: with three points in
    /// parts of up to a ninth largest pressures are off by 7e-4 where the mesh leaves 1e-3 (scene
    /// two-curved-3d), with this limit by 1e-6. It is a little less than a twelfth, so that
    /// rounding does not decide on regular meshes.
    /// @param n_facets of the face that has the first facet
    FlatPoints<2>
    common_points(const Flat<2>        &a,
                  const Flat<2>        &b,
                  const unsigned int    n_facets,
                  const SegmentRule<3> &rule)
    {
      if (apart(a, b))
        return {};
      constexpr double small_part = 0.08;
      const Polygon    ours = counterclockwise(a), p = clip(counterclockwise(b), ours);
      const bool       is_small = signed_area(p) < small_part * n_facets * signed_area(ours);
      if (rule.on_simplices.size() == 3 && (is_small || (a.is_triangle && b.is_triangle)) &&
          has_polynomials(a) && has_polynomials(b))
        return points_of_degree_2(p);
      return points_of_pieces(p, rule);
    }

    /// A piece of a side of a facet inside of another one, with its outward direction in the plane.
    template <int n>
    struct Piece
    {
      FlatPoints<n> points; ///< with lengths; 2D: a point with 1
      Tensor<1, n>  outward;
      unsigned int  side;
    };

    /// The pieces of the sides of the second facet that lie in the first one, with quadrature
    /// points (doc/theory, (5.8)).
    std::vector<Piece<1>>
    common_sides(const Flat<1> &a, const Flat<1> &b, const unsigned int /*n_points*/)
    {
      const auto [lower, upper] = std::minmax(a[0][0], a[1][0]);
      std::vector<Piece<1>> pieces;
      for (unsigned int c = 0; c < 2; ++c)
        // In the plane the sides of a facet are its two ends; the outward direction is away from
        // the other end.
        if (b[c][0] >= lower && b[c][0] <= upper)
          pieces.push_back({{{b[c], 1.}}, Tensor<1, 1>({b[c][0] > b[1 - c][0] ? 1. : -1.}), c});
      return pieces;
    }

    std::vector<Piece<2>>
    common_sides(const Flat<2> &a, const Flat<2> &b, const unsigned int n_points)
    {
      if (apart(a, b))
        return {};
      const Polygon         p    = clip(counterclockwise(b), counterclockwise(a));
      const Quadrature<1>  &rule = cell_rule<1>(ReferenceCells::Line, n_points);
      std::vector<Piece<2>> pieces;
      for (std::size_t i = 0; i < p.size(); ++i)
        {
          // The polygon is counterclockwise, so that its outside is to the right of each side.
          const Tensor<1, 2> along  = p[(i + 1) % p.size()].x - p[i].x;
          const double       length = along.norm();
          if (p[i].side == none || length == 0)
            continue;
          Piece<2> piece{{}, Tensor<1, 2>({along[1], -along[0]}) / length, unsigned(p[i].side)};
          for (unsigned int q = 0; q < rule.size(); ++q)
            piece.points.emplace_back(p[i].x + rule.point(q)[0] * along, rule.weight(q) * length);
          pieces.push_back(std::move(piece));
        }
      return pieces;
    }

    /// A facet of the slave and one of the master, projected onto the plane of the former.
    template <int dim>
    struct FacetPair
    {
      const FacePatch<dim> &slave, &master;
      const Facet<dim>     &ours, &theirs;
      const Flat<dim - 1>   ours_flat, theirs_flat;

      /// The segment point at y in the plane of the slave's facet, with the weight of doc/theory,
      /// (3.6): the measure of its part of the plane, over the Jacobian of the flat facet, times
      /// that of the true slave face.
      SegmentPoint<dim>
      at(const Point<dim - 1> &y, const double measure) const
      {
        const auto [s, jacobian] = invert<dim - 1>(ours_flat, y);
        const Point<dim - 1> xi  = ours.parameter_of_face(slave.reference_cell(), s);
        return {xi,
                theirs.parameter_of_face(master.reference_cell(),
                                         invert<dim - 1>(theirs_flat, y).first),
                measure / jacobian * Utilities::fixed_power<dim - 1>(std::abs(ours.edges[0][0])) *
                  slave.jacobian(xi)};
      }
    };

    /// Call visit(pair) for all pairs of facets of two faces.
    template <int dim, typename Visit>
    void
    for_facet_pairs(const FacetedFace<dim> &slave,
                    const FacetedFace<dim> &master,
                    const Visit            &visit)
    {
      for (const Facet<dim> &ours : slave.facets)
        {
          const auto ours_flat = project(ours, ours);
          for (const Facet<dim> &theirs : master.facets)
            visit(FacetPair<dim>{
              slave.patch, master.patch, ours, theirs, ours_flat, project(theirs, ours)});
        }
    }
  } // namespace



  // On triangles with n = 2 the rule of degree 2 by Strang and Fix, with its points inside.
  template <int dim>
  SegmentRule<dim>::SegmentRule(const unsigned int n)
    : on_simplices(cell_rule<dim - 1>(ReferenceCells::get_simplex<dim - 1>(), n))
    , on_squares(cell_rule<dim - 1>(ReferenceCells::get_hypercube<dim - 1>(), n))
  {
    if constexpr (dim == 3)
      if (n == 2)
        on_simplices = Quadrature<2>({{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}},
                                     {1. / 6, 1. / 6, 1. / 6});
  }



  // Intersect each pair of facets, and choose points in the common part. Not collective.
  template <int dim>
  std::vector<SegmentPoint<dim>>
  segment_points(const FacetedFace<dim> &slave,
                 const FacetedFace<dim> &master,
                 const SegmentRule<dim> &rule)
  {
    std::vector<SegmentPoint<dim>> points;
    for_facet_pairs(slave, master, [&](const FacetPair<dim> &pair) {
      for (const auto &[y, weight] :
           common_points(pair.ours_flat, pair.theirs_flat, slave.facets.size(), rule))
        points.push_back(pair.at(y, weight));
    });
    return points;
  }



  // The sides of the master's facets inside of the slave's facets, as far as they are sides of the
  // master face.
  template <int dim>
  std::vector<SegmentEdgePoint<dim>>
  segment_edge_points(const FacetedFace<dim> &slave,
                      const FacetedFace<dim> &master,
                      const unsigned int      n_points)
  {
    std::vector<SegmentEdgePoint<dim>> result;
    for_facet_pairs(slave, master, [&](const FacetPair<dim> &pair) {
      for (const Piece<dim - 1> &piece : common_sides(pair.ours_flat, pair.theirs_flat, n_points))
        {
          const auto side = pair.theirs.side_of_face(pair.master.reference_cell(), piece.side);
          if (!side)
            continue;
          Tensor<1, dim> outward;
          for (unsigned int d = 0; d < dim - 1; ++d)
            outward += piece.outward[d] * pair.ours.axes[d];
          for (const auto &[y, length] : piece.points)
            result.push_back({pair.at(y, length), outward, *side});
        }
    });
    return result;
  }



  template std::vector<SegmentEdgePoint<2>>
  segment_edge_points<2>(const FacetedFace<2> &, const FacetedFace<2> &, unsigned int);
  template std::vector<SegmentEdgePoint<3>>
  segment_edge_points<3>(const FacetedFace<3> &, const FacetedFace<3> &, unsigned int);
  template std::vector<SegmentPoint<2>>
  segment_points<2>(const FacetedFace<2> &, const FacetedFace<2> &, const SegmentRule<2> &);
  template std::vector<SegmentPoint<3>>
  segment_points<3>(const FacetedFace<3> &, const FacetedFace<3> &, const SegmentRule<3> &);
  template struct SegmentRule<2>;
  template struct SegmentRule<3>;
} // namespace Signorini
