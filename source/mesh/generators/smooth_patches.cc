#include <signorini/mesh/generators/cells.h>
#include <signorini/mesh/generators/smooth_patches.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Sets that grow together.
    class Union
    {
    public:
      explicit Union(const unsigned int n)
        : parent(n)
      {
        std::iota(parent.begin(), parent.end(), 0);
      }

      unsigned int
      root(unsigned int i)
      {
        while (parent[i] != i)
          i = parent[i] = parent[parent[i]];
        return i;
      }

      void
      join(const unsigned int i, const unsigned int j)
      {
        parent[root(j)] = root(i);
      }

    private:
      std::vector<unsigned int> parent;
    };



    template <int dim>
    Point<dim>
    center_of(const std::vector<unsigned int> &nodes, const std::vector<Point<dim>> &vertices)
    {
      Point<dim> center;
      for (const unsigned int node : nodes)
        center += vertices[node] / double(nodes.size());
      return center;
    }



    /// Where faces meet: vertices in 2D, edges in 3D.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    rims_of(const std::vector<unsigned int> &v)
    {
      if (dim == 2)
        return {{v[0]}, {v[1]}};
      return {sorted({v[0], v[1]}),
              sorted({v[2], v[3]}),
              sorted({v[0], v[2]}),
              sorted({v[1], v[3]})};
    }



    /// Unit vector from the rim into the face, normal to the rim.
    template <int dim>
    Tensor<1, dim>
    inward(const std::vector<unsigned int> &rim,
           const std::vector<unsigned int> &face,
           const std::vector<Point<dim>>   &vertices)
    {
      Tensor<1, dim> arm = center_of(face, vertices) - center_of(rim, vertices);
      if (rim.size() == 2)
        {
          const Tensor<1, dim> along = vertices[rim[1]] - vertices[rim[0]];
          arm -= (arm * along) / along.norm_square() * along;
        }
      return arm / arm.norm();
    }



    template <int dim>
    Union
    connected(const std::vector<CellData<dim - 1>> &faces,
              const std::vector<Point<dim>>        &vertices,
              const double                          angle)
    {
      std::map<std::vector<unsigned int>, std::vector<unsigned int>> at_rim;
      for (unsigned int f = 0; f < faces.size(); ++f)
        for (const auto &rim : rims_of<dim>(faces[f].vertices))
          at_rim[rim].push_back(f);

      // Faces that go on straight lie opposite to each other.
      const double limit = std::cos(angle * numbers::PI / 180);
      Union        sets(faces.size());
      for (const auto &[rim, members] : at_rim)
        for (unsigned int i = 0; i < members.size(); ++i)
          for (unsigned int j = 0; j < i; ++j)
            if (-(inward(rim, faces[members[i]].vertices, vertices) *
                  inward(rim, faces[members[j]].vertices, vertices)) >= limit)
              sets.join(members[i], members[j]);
      return sets;
    }



    /// Coordinates of the center and the mean distance from it, in steps well above rounding.
    template <int dim>
    std::array<long, dim + 1>
    place_of(const SmoothPatch<dim>               &patch,
             const std::vector<CellData<dim - 1>> &faces,
             const std::vector<Point<dim>>        &vertices)
    {
      double size = 0, spread = 0;
      for (const auto &face : faces)
        size = std::max(size, vertices[face.vertices[0]].distance(vertices[faces[0].vertices[0]]));
      for (const unsigned int f : patch.faces)
        spread +=
          patch.center.distance(center_of(faces[f].vertices, vertices)) / patch.faces.size();
      std::array<long, dim + 1> place;
      for (unsigned int d = 0; d < dim; ++d)
        place[d] = std::lround((patch.center[d] - vertices[0][d]) / (1e-6 * size));
      place[dim] = std::lround(spread / (1e-6 * size));
      return place;
    }
  } // namespace



  template <int dim>
  std::vector<SmoothPatch<dim>>
  smooth_patches(const std::vector<CellData<dim - 1>> &faces,
                 const std::vector<Point<dim>>        &vertices,
                 const double                          angle)
  {
    Union                                    sets = connected(faces, vertices, angle);
    std::map<unsigned int, SmoothPatch<dim>> by_root;
    for (unsigned int f = 0; f < faces.size(); ++f)
      by_root[sets.root(f)].faces.push_back(f);

    std::multimap<std::array<long, dim + 1>, SmoothPatch<dim>> by_place;
    for (auto &[root, patch] : by_root)
      {
        for (const unsigned int f : patch.faces)
          patch.center += center_of(faces[f].vertices, vertices) / double(patch.faces.size());
        by_place.insert({place_of(patch, faces, vertices), patch});
      }
    std::vector<SmoothPatch<dim>> patches;
    for (const auto &[place, patch] : by_place)
      patches.push_back(patch);
    return patches;
  }



  template std::vector<SmoothPatch<2>>
  smooth_patches(const std::vector<CellData<1>> &, const std::vector<Point<2>> &, double);
  template std::vector<SmoothPatch<3>>
  smooth_patches(const std::vector<CellData<2>> &, const std::vector<Point<3>> &, double);
} // namespace Signorini
