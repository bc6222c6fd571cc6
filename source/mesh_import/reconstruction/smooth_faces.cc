// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/reconstruction/smooth_faces.h"

#include "geometry/connected.h"
#include "mesh_import/reconstruction/facets.h"
#include "mesh_import/reconstruction/local_surface.h"

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

      SmoothFaces<dim>
      find()
      {
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
              result.faces.push_back({f, edges, uncertainty_of(f, CurvedFace<dim>(edges))});
            }
        return result;
      }

    private:
      using Corner = std::pair<unsigned int, unsigned int>; ///< vertex, patch

      void
      fit_all()
      {
        for (unsigned int f = 0; f < graph.faces.size(); ++f)
          if (!known[f])
            for (const unsigned int v : graph.faces[f].vertices)
              if (fits.count({v, patch_of[f]}) == 0)
                fits[{v, patch_of[f]}] = fit(v, patch_of[f]);
      }

      /// Around a vertex, ring by ring.
      LocalSurface<dim>
      fit(const unsigned int v, const unsigned int patch) const
      {
        std::vector<unsigned int> faces;
        for (const unsigned int f : around[v])
          if (patch_of[f] == patch)
            faces.push_back(f);
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

      const LocalSurface<dim> &
      at(const unsigned int v, const unsigned int f) const
      {
        return fits.at({v, patch_of[f]});
      }

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

      /// Twice as far as the middle of a face is from what its corners say: at ends of curves the
      /// error was up to one and a half times that, elsewhere less.
      double
      uncertainty_of(const unsigned int f, const CurvedFace<dim> &face) const
      {
        Point<dim - 1> middle;
        for (unsigned int d = 0; d < dim - 1; ++d)
          middle[d] = 0.5;
        double result = 0;
        for (const unsigned int v : graph.faces[f].vertices)
          result =
            std::max(result, at(v, f).distance(face.push_forward(middle) - graph.vertices[v]));
        return 2 * result;
      }

      /// Of the surface that a face stands for, if it is one.
      Tensor<1, dim>
      normal_at(const unsigned int v, const unsigned int f) const
      {
        return !known[f] && at(v, f).fits ? at(v, f).normal : graph.normal(f);
      }

      /// The shortest way of a vertex onto all surfaces that meet there.
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
        // Faces that are nearly in one plane shall not push the vertex along it.
        solver.setThreshold(0.1);
        const Eigen::VectorXd x = solver.compute(A).solve(b);
        Tensor<1, dim>        result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = x(d);
        return result;
      }

      /// Unit vector along the chord in the surfaces on both sides of an edge.
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
        // What turns more than facets may is no curve.
        const double least = 0.8 * chord.norm();
        if (start * chord < least || end * chord < least)
          return {vertices[v], vertices[w]};
        return {vertices[v], vertices[w], start, end};
      }

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
            return {{edge(0, 2), edge(1, 3), edge(0, 1), edge(2, 3)}};
          }
      }

      const FacetGraph<dim>                 &graph;
      const std::vector<bool>               &inserted, &known;
      std::vector<std::vector<unsigned int>> around; ///< faces at vertices
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
