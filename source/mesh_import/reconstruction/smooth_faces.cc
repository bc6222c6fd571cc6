// SPDX-License-Identifier: Apache-2.0
#include "geometry/connected.h"
#include "mesh_import/reconstruction/curved_faces.h"
#include "mesh_import/reconstruction/facets.h"

#include <cmath>
#include <map>
#include <set>

#include <Eigen/Dense>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_fit_share = 0.25; // of the sagitta, that corners may be off the fit
    constexpr double kink              = 15;   // [degrees] between surfaces that meet in an edge
    constexpr double straight          = 1e-4; // [radians] of normals, that make no difference

    /// Reconstructs smooth surfaces (see find_smooth_faces()). A patch is a set of faces that are
    /// connected in the graph and are all known or all unknown; each pair of vertex and patch has a
    /// LocalSurface of its own, so that a vertex at a sharp edge has one normal on each side.
    template <int dim>
    class SmoothFaceFinder
    {
    public:
      SmoothFaceFinder(const FacetGraph<dim> &graph, const std::vector<bool> &known)
        : graph(graph)
        , inserted(graph.inserted)
        , known(known)
        , around(graph.vertices.size())
      {
        Connected patches(graph.faces.size());
        for (unsigned int f = 0; f < graph.faces.size(); ++f)
          {
            for (const unsigned int v : graph.faces[f].vertices)
              around[v].push_back(f);
            for (const auto &n : graph.neighbours(f))
              if (known[f] == known[n.face])
                patches.connect(f, n.face);
          }
        for (unsigned int f = 0; f < graph.faces.size(); ++f)
          patch_of.push_back(patches.first_of(f));
      }

      // (1) Fit a polynomial at each corner of each patch; (2) move inserted vertices onto the
      // fitted surfaces; (3) give each curved face whose corners all have a fit four cubic edges.
      SmoothFaces<dim>
      find()
      {
        /// Fit all pairs of vertex and patch; those of known faces are not needed.
        fit_all();
        SmoothFaces<dim> result;
        result.vertices = graph.vertices;
        for (unsigned int v = 0; v < around.size(); ++v)
          if (inserted[v])
            result.vertices[v] += shift(v);
        std::map<std::vector<unsigned int>, std::vector<unsigned int>> at_rim;
        if (dim == 3)
          for (unsigned int f = 0; f < graph.faces.size(); ++f)
            for (const auto &rim : rims_of<dim>(graph.faces[f].vertices))
              at_rim[rim].push_back(f);
        for (unsigned int f = 0; f < graph.faces.size(); ++f)
          if (is_smooth(f))
            {
              const auto edges = edges_of(f, result.vertices, at_rim);
              result.faces.push_back({f, edges, uncertainty_of(f, middle_of(f, edges))});
            }
        return result;
      }

    private:
      /// A vertex and the patch to which its fit belongs.
      using Corner = std::pair<unsigned int, unsigned int>;

      void
      fit_all()
      {
        for (unsigned int f = 0; f < graph.faces.size(); ++f)
          if (!known[f])
            for (const unsigned int v : graph.faces[f].vertices)
              if (fits.count({v, patch_of[f]}) == 0)
                fits[{v, patch_of[f]}] = fit(v, patch_of[f]);
      }

      /// @return the surface at a vertex, fitted to the corners of the patch around it. Rings of
      /// faces are added until there are LocalSurface::enough corners, or the patch has no more
      /// faces. If all these faces are in one plane, that is the surface. The fit is rejected if it
      /// deviates from the corners by more than a quarter of the sagitta of the facets: there is a
      /// kink or a jump of the curvature.
      LocalSurface<dim>
      fit(const unsigned int v, const unsigned int patch) const
      {
        std::vector<unsigned int> faces;
        for (const unsigned int f : around[v])
          if (patch_of[f] == patch)
            faces.push_back(f);
        // Normals have arbitrary signs: they are aligned with the first one before they are added.
        std::set<unsigned int> seen(faces.begin(), faces.end()), corners;
        const Tensor<1, dim>   first = graph.normal(faces[0]);
        Tensor<1, dim>         mean;
        for (std::size_t done = 0; done < faces.size();)
          {
            const std::size_t n = faces.size();
            for (; done < n; ++done)
              {
                const Tensor<1, dim> &normal = graph.normal(faces[done]);
                mean += normal * first < 0 ? -normal : normal;
                for (const unsigned int corner : graph.faces[faces[done]].vertices)
                  if (corner != v && !inserted[corner])
                    corners.insert(corner);
              }
            if (corners.size() >= LocalSurface<dim>::enough)
              break;
            for (std::size_t i = 0; i < n; ++i)
              for (const unsigned int corner : graph.faces[faces[i]].vertices)
                for (const unsigned int f : around[corner])
                  if (patch_of[f] == patch && seen.insert(f).second)
                    faces.push_back(f);
          }
        if (graph.sagitta(faces) == 0)
          return LocalSurface<dim>::plane(graph.normal(faces[0]));
        std::vector<Tensor<1, dim>> arms;
        for (const unsigned int corner : corners)
          arms.push_back(graph.vertices[corner] - graph.vertices[v]);
        LocalSurface<dim> result(arms, mean / mean.norm(), !inserted[v]);
        result.fits = result.fits && result.deviation <= largest_fit_share * graph.sagitta(faces);
        return result;
      }

      /// @return the surface at vertex v of face f, which is not a known one.
      const LocalSurface<dim> &
      at(const unsigned int v, const unsigned int f) const
      {
        return fits.at({v, patch_of[f]});
      }

      /// @return whether a face becomes curved: all its corners have a fit, and at least one normal
      /// differs from that of the face.
      bool
      is_smooth(const unsigned int f) const
      {
        if (known[f])
          return false;
        bool is_curved = false;
        for (const unsigned int v : graph.faces[f].vertices)
          {
            if (!at(v, f).fits)
              return false;
            const double cosine = std::abs(at(v, f).normal * graph.normal(f));
            is_curved           = is_curved || cosine < std::cos(straight);
          }
        return is_curved;
      }

      /// @return the middle of a curved face: of a triangle that of the quadratic one through the
      /// middles of its edges.
      Point<dim>
      middle_of(const unsigned int f, const typename CurvedFace<dim>::Edges &edges) const
      {
        const std::vector<unsigned int> &v = graph.faces[f].vertices;
        if (dim == 3 && v.size() == 3)
          {
            Tensor<1, dim> sum;
            for (unsigned int i = 0; i < 3; ++i)
              sum += 4. / 9 * edges[i].value(0.5) - 1. / 9 * graph.vertices[v[i]];
            return Point<dim>(sum);
          }
        Point<dim - 1> middle;
        for (unsigned int d = 0; d < dim - 1; ++d)
          middle[d] = 0.5;
        return CurvedFace<dim>(edges).push_forward(middle);
      }

      /// @return an estimate of the distance [length] of the curved face from the true surface:
      /// twice the largest distance of its middle from the surfaces fitted at its corners. In
      /// measurements the error was up to one and a half times that distance at ends of curves, and
      /// less elsewhere.
      double
      uncertainty_of(const unsigned int f, const Point<dim> &middle) const
      {
        double result = 0;
        for (const unsigned int v : graph.faces[f].vertices)
          result = std::max(result, at(v, f).distance(middle - graph.vertices[v]));
        return 2 * result;
      }

      /// @return the unit normal at vertex v of the surface that face f approximates; that of the
      /// facet itself if no surface was fitted.
      Tensor<1, dim>
      normal_at(const unsigned int v, const unsigned int f) const
      {
        return !known[f] && at(v, f).fits ? at(v, f).normal : graph.normal(f);
      }

      /// @return the shortest displacement that brings an inserted vertex onto the tangent planes
      /// of all surfaces that meet there, by minimal-norm least squares of n_i.x = offset_i. Zero
      /// at vertices of known faces.
      Tensor<1, dim>
      shift(const unsigned int v) const
      {
        Eigen::MatrixXd A(around[v].size(), int(dim));
        Eigen::VectorXd b(around[v].size());
        bool            any = false;
        for (unsigned int i = 0; i < around[v].size(); ++i)
          {
            const unsigned int   f      = around[v][i];
            const Tensor<1, dim> normal = normal_at(v, f);
            const bool           fits   = !known[f] && at(v, f).fits;
            if (known[f])
              return {};
            for (unsigned int d = 0; d < dim; ++d)
              A(i, d) = normal[d];
            b(i) = fits ? at(v, f).offset : 0.;
            any  = any || b(i) != 0;
          }
        if (!any)
          return {};
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
        // Singular values below a tenth of the largest count as zero: faces that are nearly in one
        // plane must not move the vertex along this plane.
        solver.setThreshold(0.1);
        const Eigen::VectorXd x = solver.compute(A).solve(b);
        Tensor<1, dim>        result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = x(d);
        return result;
      }

      /// @return the unit tangent, at an end of an edge, of the curve in which the surfaces on both
      /// sides meet. Where they have (nearly) the same normal it is the projection of the chord
      /// onto the tangent plane; where they meet at an angle of more than 15 degrees it is the
      /// intersection of both tangent planes.
      Tensor<1, dim>
      tangent(Tensor<1, dim> chord, const Tensor<1, dim> &a, Tensor<1, dim> b) const
      {
        chord /= chord.norm();
        if (a * b < 0)
          b = -b;
        Tensor<1, dim> normal = a + b;
        normal /= normal.norm();
        Tensor<1, dim> result = chord - (chord * normal) * normal;
        if constexpr (dim == 3)
          if (a * b < std::cos(kink * numbers::PI / 180))
            {
              result = cross_product_3d(a, b);
              if (result * chord < 0)
                result = -result;
            }
        return result / result.norm();
      }

      /// @return the cubic curve from vertex v to w between the faces f and g, with the tangents of
      /// the surfaces at both ends; a straight line if a tangent deviates from the chord by more
      /// than 37 degrees, which is more than two facets that are neighbours may differ.
      CubicCurve<dim>
      curve(const unsigned int             v,
            const unsigned int             w,
            const unsigned int             f,
            const unsigned int             g,
            const std::vector<Point<dim>> &vertices) const
      {
        const Tensor<1, dim> chord = vertices[w] - vertices[v],
                             start = tangent(chord, normal_at(v, f), normal_at(v, g)),
                             end   = tangent(chord, normal_at(w, f), normal_at(w, g));
        // The directions are compared with a cosine of 0.8.
        const double least = 0.8 * chord.norm();
        if (start * chord < least || end * chord < least)
          return {vertices[v], vertices[w]};
        return {vertices[v], vertices[w], start, end};
      }

      /// @return the edges of a face as CurvedFace expects them: the curve itself in 2D, in 3D the
      /// two edges along the second coordinate and then the two along the first; those of triangles
      /// around, the last one twice. Both faces at an edge give it the same curve, so that the
      /// reconstructed surface is continuous.
      typename CurvedFace<dim>::Edges
      edges_of(const unsigned int                                                    f,
               const std::vector<Point<dim>>                                        &vertices,
               const std::map<std::vector<unsigned int>, std::vector<unsigned int>> &at_rim) const
      {
        const std::vector<unsigned int> &v = graph.faces[f].vertices;
        if constexpr (dim == 2)
          return {{curve(v[0], v[1], f, f, vertices)}};
        else
          {
            const auto edge = [&](const unsigned int i, const unsigned int j) {
              const std::vector<unsigned int> &both = at_rim.at(sorted({v[i], v[j]}));
              const unsigned int other = both.size() != 2 ? f : both[0] == f ? both[1] : both[0];
              return curve(v[i], v[j], f, other, vertices);
            };
            if (v.size() == 3)
              return {{edge(0, 1), edge(1, 2), edge(2, 0), edge(2, 0)}};
            return {{edge(0, 2), edge(1, 3), edge(0, 1), edge(2, 3)}};
          }
      }

      const FacetGraph<dim>   &graph;
      const std::vector<bool> &inserted, &known;
      /// The faces at each vertex.
      std::vector<std::vector<unsigned int>> around;
      std::vector<unsigned int>              patch_of;
      std::map<Corner, LocalSurface<dim>>    fits;
    };
  } // namespace



  template <int dim>
  SmoothFaces<dim>
  find_smooth_faces(const FacetGraph<dim> &graph, const std::vector<bool> &known)
  {
    return SmoothFaceFinder<dim>(graph, known).find();
  }



  template SmoothFaces<2>
  find_smooth_faces(const FacetGraph<2> &, const std::vector<bool> &);
  template SmoothFaces<3>
  find_smooth_faces(const FacetGraph<3> &, const std::vector<bool> &);
} // namespace Signorini
