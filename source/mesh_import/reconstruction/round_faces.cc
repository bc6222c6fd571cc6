// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/reconstruction/curved_faces.h"

#include <algorithm>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_deviation_share = 0.01; // of the sagitta, that corners may be off
    constexpr unsigned int max_seeds = 200; // in vain, before a mesh is taken for what it is

    /// Region growing (see find_round_faces()): a few connected faces are the seed, to which a
    /// surface is fitted; neighbours whose corners are on the surface are added one after the
    /// other, and the surface is fitted anew whenever the number of faces has doubled. Each face
    /// belongs to at most one surface, so that the growth of all regions together takes O(n log n)
    /// for n faces, beside the seeds in vain.
    template <int dim>
    class RoundFaceFinder
    {
    public:
      explicit RoundFaceFinder(const FacetGraph<dim> &graph)
        : graph(graph)
        , faces(graph.faces)
        , vertices(graph.vertices)
        , inserted(graph.inserted)
        , used(faces.size(), false)
      {}

      // A mesh without round surfaces is not searched to its end: the search stops after
      // `max_seeds` curved seeds in vain.
      Facets<dim>
      find()
      {
        Facets<dim>  result;
        unsigned int in_vain = 0;
        for (unsigned int seed = 0; seed < faces.size() && in_vain < max_seeds; ++seed)
          if (!used[seed] && !graph.neighbours(seed).empty())
            {
              if (auto found = grow_region(seed))
                result.round.push_back(std::move(*found));
              else if (graph.sagitta({seed}) > 0)
                ++in_vain;
            }
        for (unsigned int f = 0; f < faces.size(); ++f)
          result.sagitta.push_back(used[f] ? 0. : graph.sagitta({f}));
        return result;
      }

    private:
      /// @return the vertices of these faces, in ascending order and without the inserted ones,
      /// which need not be on the surface.
      std::vector<unsigned int>
      corners_of(const std::vector<unsigned int> &some) const
      {
        std::set<unsigned int> corners;
        for (const unsigned int f : some)
          for (const unsigned int v : faces[f].vertices)
            if (!inserted[v])
              corners.insert(v);
        return {corners.begin(), corners.end()};
      }

      /// @return the unused faces around one in order of their distance in the graph, as many as
      /// are needed to distinguish the kinds of surfaces by their corners.
      std::vector<unsigned int>
      seed_around(const unsigned int first) const
      {
        constexpr unsigned int    enough = dim == 2 ? 4 : 12;
        std::vector<unsigned int> some{first};
        std::set<unsigned int>    known{first};
        for (unsigned int i = 0; i < some.size() && corners_of(some).size() < enough; ++i)
          for (const auto &n : graph.neighbours(some[i]))
            if (!used[n.face] && known.insert(n.face).second)
              some.push_back(n.face);
        return some;
      }

      /// @return the surface through the corners of these faces, or none. Only the normals of the
      /// first n faces are used, with signs that agree with that of the first: they are near each
      /// other, while those of faces on opposite sides would get arbitrary signs.
      std::optional<FittedSurface<dim>>
      fit(const std::vector<unsigned int> &some, const std::size_t n, const double tolerance) const
      {
        std::vector<Point<dim>>     points;
        std::vector<Tensor<1, dim>> normals_there;
        for (const unsigned int v : corners_of(some))
          points.push_back(vertices[v]);
        for (std::size_t i = 0; i < n; ++i)
          {
            const Tensor<1, dim> &normal = graph.normal(some[i]);
            normals_there.push_back(normal * graph.normal(some[0]) < 0 ? -normal : normal);
          }
        return fit_surface(points, normals_there, tolerance);
      }

      /// @return whether all corners of a face are on a surface.
      bool
      lies_on(const unsigned int f, const FittedSurface<dim> &surface, const double tolerance) const
      {
        for (const unsigned int v : faces[f].vertices)
          if (!inserted[v] && !(surface.distance(vertices[v]) <= tolerance))
            return false;
        return true;
      }

      /// @return the faces around the seed that are one round surface, which become used; none if
      /// no surface fits, or too few corners are on it.
      std::optional<RoundFaces<dim>>
      grow_region(const unsigned int seed)
      {
        constexpr unsigned int    least     = dim == 2 ? 5 : 9;
        std::vector<unsigned int> some      = seed_around(seed);
        const double              tolerance = largest_deviation_share * graph.sagitta(some);
        if (tolerance == 0 || corners_of(some).size() < (dim == 2 ? 4 : 9))
          return {};
        const std::size_t n_seed  = some.size();
        auto              surface = fit(some, n_seed, tolerance);
        if (!surface)
          return {};
        std::set<unsigned int> known(some.begin(), some.end());
        std::size_t            fitted = n_seed;
        for (unsigned int i = 0; i < some.size(); ++i)
          {
            for (const auto &n : graph.neighbours(some[i]))
              if (!used[n.face] && known.count(n.face) == 0 && lies_on(n.face, *surface, tolerance))
                {
                  known.insert(n.face);
                  some.push_back(n.face);
                }
            // With more corners the surface is determined better. It is fitted anew when the number
            // of faces has doubled, and at the end. The last fit has to succeed.
            const bool is_last = i + 1 == some.size();
            if (some.size() >= 2 * fitted || (is_last && some.size() > fitted))
              {
                fitted = some.size();
                if (auto better = fit(some, n_seed, tolerance))
                  surface = better;
                else if (is_last)
                  return {};
              }
          }
        if (corners_of(some).size() < least)
          return {};
        for (const unsigned int f : some)
          used[f] = true;
        return RoundFaces<dim>{*surface, some, graph.sagitta(some)};
      }

      const FacetGraph<dim>                &graph;
      const std::vector<CellData<dim - 1>> &faces;
      const std::vector<Point<dim>>        &vertices;
      const std::vector<bool>              &inserted;
      std::vector<bool>                     used;
    };
  } // namespace



  template <int dim>
  Facets<dim>
  find_round_faces(const FacetGraph<dim> &graph)
  {
    return RoundFaceFinder<dim>(graph).find();
  }



  template Facets<2>
  find_round_faces(const FacetGraph<2> &);
  template Facets<3>
  find_round_faces(const FacetGraph<3> &);
} // namespace Signorini
