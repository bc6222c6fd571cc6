// SPDX-License-Identifier: Apache-2.0
#include "geometry/connected.h"
#include "mesh_import/file_part_steps.h"
#include "mesh_import/reconstruction/facets.h"

#include <array>
#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the faces as sets that are connected at rims where the surface bends by at most
    /// `angle` degrees.
    template <int dim>
    Connected
    connected(const std::vector<CellData<dim - 1>> &faces,
              const std::vector<Point<dim>>        &vertices,
              const double                          angle)
    {
      std::map<std::vector<unsigned int>, std::vector<unsigned int>> at_rim;
      for (unsigned int f = 0; f < faces.size(); ++f)
        for (const auto &rim : rims_of<dim>(faces[f].vertices))
          at_rim[rim].push_back(f);

      // The inward directions of two faces in one plane are opposite, see FacetGraph::join().
      const double limit = std::cos(angle * numbers::PI / 180);
      Connected    sets(faces.size());
      for (const auto &[rim, members] : at_rim)
        for (unsigned int i = 0; i < members.size(); ++i)
          for (unsigned int j = 0; j < i; ++j)
            if (-(inward(rim, faces[members[i]].vertices, vertices) *
                  inward(rim, faces[members[j]].vertices, vertices)) >= limit)
              sets.connect(members[i], members[j]);
      return sets;
    }



    /// A line (2D) or a triangle (3D) with its length or area and its centre of gravity. Patches
    /// are integrated over these, so that the centre of a plane patch does not depend on its mesh.
    template <int dim>
    struct Facet
    {
      double     size;
      Point<dim> center;
    };



    /// @return the line or triangle itself, or the two triangles of a quadrilateral.
    template <int dim>
    std::vector<Facet<dim>>
    pieces_of(const CellData<dim - 1> &face, const std::vector<Point<dim>> &vertices)
    {
      const std::vector<unsigned int> &v = face.vertices;
      if constexpr (dim == 2)
        return {{vertices[v[0]].distance(vertices[v[1]]), center_of(v, vertices)}};
      else
        {
          const auto triangle =
            [&](const unsigned int i, const unsigned int j, const unsigned int k) {
              const Tensor<1, dim> a = vertices[j] - vertices[i], b = vertices[k] - vertices[i];
              return Facet<dim>{cross_product_3d(a, b).norm() / 2, center_of({i, j, k}, vertices)};
            };
          if (v.size() == 3)
            return {triangle(v[0], v[1], v[2])};
          return {triangle(v[0], v[1], v[2]), triangle(v[3], v[2], v[1])};
        }
    }



    /// Compute the centre of gravity of a patch.
    /// @return the key by which patches are sorted: the coordinates of the centre and the mean
    /// distance from it, in multiples of `step`, which is well above rounding, so that the order is
    /// reproducible
    template <int dim>
    std::array<long, dim + 1>
    place(SmoothPatch<dim>                     &patch,
          const std::vector<CellData<dim - 1>> &faces,
          const std::vector<Point<dim>>        &vertices,
          const double                          step)
    {
      double sum = 0, spread = 0;
      for (const unsigned int f : patch.faces)
        for (const auto &piece : pieces_of<dim>(faces[f], vertices))
          {
            sum += piece.size;
            patch.center += piece.size * piece.center;
          }
      patch.center /= sum;
      for (const unsigned int f : patch.faces)
        for (const auto &piece : pieces_of<dim>(faces[f], vertices))
          spread += piece.size / sum * patch.center.distance(piece.center);

      std::array<long, dim + 1> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = std::lround((patch.center[d] - vertices[0][d]) / step);
      result[dim] = std::lround(spread / step);
      return result;
    }



    /// @return the largest distance of a vertex of the faces from the first one.
    template <int dim>
    double
    size_of(const std::vector<CellData<dim - 1>> &faces, const std::vector<Point<dim>> &vertices)
    {
      double size = 0;
      for (const auto &face : faces)
        for (const unsigned int node : face.vertices)
          size = std::max(size, vertices[node].distance(vertices[faces[0].vertices[0]]));
      return size;
    }
  } // namespace



  // The multimap sorts patches by position; equal keys keep the order of the faces.
  template <int dim>
  std::vector<SmoothPatch<dim>>
  smooth_patches(const std::vector<CellData<dim - 1>> &faces,
                 const std::vector<Point<dim>>        &vertices,
                 const double                          angle)
  {
    Connected                                sets = connected(faces, vertices, angle);
    std::map<unsigned int, SmoothPatch<dim>> by_first;
    for (unsigned int f = 0; f < faces.size(); ++f)
      by_first[sets.first_of(f)].faces.push_back(f);

    const double step = 1e-6 * size_of<dim>(faces, vertices);
    std::multimap<std::array<long, dim + 1>, SmoothPatch<dim>> by_place;
    for (auto &[first, patch] : by_first)
      {
        const auto at = place(patch, faces, vertices, step);
        by_place.insert({at, patch});
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
