#include <signorini/mesh/generators/facets.h>
#include <signorini/mesh/generators/round_faces.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double       largest_angle = 35; // [degrees] between facets: 12 on a circle and more
    constexpr double       largest_share = 0.01; // of the sagitta, that corners may be off
    constexpr unsigned int max_seeds     = 200;  // in vain, before a mesh is taken for what it is

    template <int dim>
    Tensor<1, dim>
    normal_of(const std::vector<unsigned int> &v, const std::vector<Point<dim>> &vertices)
    {
      Tensor<1, dim> n;
      if constexpr (dim == 2)
        n = cross_product_2d(vertices[v[1]] - vertices[v[0]]);
      else
        n = cross_product_3d(vertices[v[3]] - vertices[v[0]], vertices[v[2]] - vertices[v[1]]);
      return n / n.norm();
    }

    template <int dim>
    class Finder
    {
    public:
      Finder(const std::vector<CellData<dim - 1>> &faces,
             const std::vector<Point<dim>>        &vertices,
             const std::vector<bool>              &made)
        : faces(faces)
        , vertices(vertices)
        , made(made)
        , neighbours(faces.size())
        , used(faces.size(), false)
      {
        for (const auto &face : faces)
          {
            normals.push_back(normal_of<dim>(face.vertices, vertices));
            centers.push_back(center_of(face.vertices, vertices));
          }
        std::map<std::vector<unsigned int>, std::vector<unsigned int>> at_rim;
        for (unsigned int f = 0; f < faces.size(); ++f)
          for (const auto &rim : rims_of<dim>(faces[f].vertices))
            at_rim[rim].push_back(f);
        for (const auto &[rim, members] : at_rim)
          if (members.size() == 2)
            join(rim, members[0], members[1]);
      }

      Facets<dim>
      find()
      {
        Facets<dim>  result;
        unsigned int in_vain = 0;
        for (unsigned int seed = 0; seed < faces.size() && in_vain < max_seeds; ++seed)
          if (!used[seed] && !neighbours[seed].empty())
            {
              if (auto found = grown_from(seed))
                result.round.push_back(std::move(*found));
              else if (sagitta({seed}) > 0)
                ++in_vain;
            }
        for (unsigned int f = 0; f < faces.size(); ++f)
          result.sagitta.push_back(used[f] ? 0. : sagitta({f}));
        return result;
      }

    private:
      struct Neighbour
      {
        unsigned int face;
        double       sagitta; ///< of a chord between the middles of both
      };

      void
      join(const std::vector<unsigned int> &rim, const unsigned int a, const unsigned int b)
      {
        // Faces that go on straight lie opposite to each other.
        const double cosine =
          -(inward(rim, faces[a].vertices, vertices) * inward(rim, faces[b].vertices, vertices));
        if (cosine < std::cos(largest_angle * numbers::PI / 180))
          return;
        const double angle   = std::acos(std::min(1., cosine));
        const double sagitta = angle > 1e-5 ? centers[a].distance(centers[b]) * angle / 8 : 0.;
        neighbours[a].push_back({b, sagitta});
        neighbours[b].push_back({a, sagitta});
      }

      double
      sagitta(const std::vector<unsigned int> &some) const
      {
        double largest = 0;
        for (const unsigned int f : some)
          for (const Neighbour &n : neighbours[f])
            largest = std::max(largest, n.sagitta);
        return largest;
      }

      std::vector<unsigned int>
      corners_of(const std::vector<unsigned int> &some) const
      {
        std::set<unsigned int> corners;
        for (const unsigned int f : some)
          for (const unsigned int v : faces[f].vertices)
            if (!made[v])
              corners.insert(v);
        return {corners.begin(), corners.end()};
      }

      /// Faces around one, until there are enough corners to tell one kind from another.
      std::vector<unsigned int>
      seed_around(const unsigned int first) const
      {
        constexpr unsigned int    enough = dim == 2 ? 4 : 12;
        std::vector<unsigned int> some{first};
        std::set<unsigned int>    known{first};
        for (unsigned int i = 0; i < some.size() && corners_of(some).size() < enough; ++i)
          for (const Neighbour &n : neighbours[some[i]])
            if (!used[n.face] && known.insert(n.face).second)
              some.push_back(n.face);
        return some;
      }

      /// Only the normals of the first n, which are near each other: those of opposite faces may be
      /// of any orientation.
      std::optional<FittedSurface<dim>>
      fit(const std::vector<unsigned int> &some, const std::size_t n, const double tolerance) const
      {
        std::vector<Point<dim>>     points;
        std::vector<Tensor<1, dim>> normals_there;
        for (const unsigned int v : corners_of(some))
          points.push_back(vertices[v]);
        for (std::size_t i = 0; i < n; ++i)
          normals_there.push_back(normals[some[i]] * normals[some[0]] < 0 ? -normals[some[i]] :
                                                                            normals[some[i]]);
        return fit_surface(points, normals_there, tolerance);
      }

      bool
      lies_on(const unsigned int f, const FittedSurface<dim> &surface, const double tolerance) const
      {
        for (const unsigned int v : faces[f].vertices)
          if (!made[v] && !(surface.distance(vertices[v]) <= tolerance))
            return false;
        return true;
      }

      std::optional<RoundFaces<dim>>
      grown_from(const unsigned int seed)
      {
        constexpr unsigned int    least     = dim == 2 ? 5 : 9;
        std::vector<unsigned int> some      = seed_around(seed);
        const double              tolerance = largest_share * sagitta(some);
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
            for (const Neighbour &n : neighbours[some[i]])
              if (!used[n.face] && known.count(n.face) == 0 && lies_on(n.face, *surface, tolerance))
                {
                  known.insert(n.face);
                  some.push_back(n.face);
                }
            // The more corners, the better the surface is known.
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
        return RoundFaces<dim>{*surface, some, sagitta(some)};
      }

      const std::vector<CellData<dim - 1>> &faces;
      const std::vector<Point<dim>>        &vertices;
      const std::vector<bool>              &made;
      std::vector<Tensor<1, dim>>           normals;
      std::vector<Point<dim>>               centers;
      std::vector<std::vector<Neighbour>>   neighbours; ///< across smooth rims
      std::vector<bool>                     used;
    };
  } // namespace



  template <int dim>
  Facets<dim>
  find_round_faces(const std::vector<CellData<dim - 1>> &faces,
                   const std::vector<Point<dim>>        &vertices,
                   const std::vector<bool>              &made)
  {
    return Finder<dim>(faces, vertices, made).find();
  }



  template Facets<2>
  find_round_faces(const std::vector<CellData<1>> &,
                   const std::vector<Point<2>> &,
                   const std::vector<bool> &);
  template Facets<3>
  find_round_faces(const std::vector<CellData<2>> &,
                   const std::vector<Point<3>> &,
                   const std::vector<bool> &);
} // namespace Signorini
