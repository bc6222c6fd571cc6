// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/reconstruction/facet_graph.h"

#include "mesh_import/reconstruction/facets.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_angle = 35; // [degrees] between facets: 12 on a circle and more

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
  } // namespace



  template <int dim>
  FacetGraph<dim>::FacetGraph(const std::vector<CellData<dim - 1>> &faces,
                              const std::vector<Point<dim>>        &vertices,
                              const std::vector<bool>              &inserted)
    : faces(faces)
    , vertices(vertices)
    , inserted(inserted)
    , of_faces(faces.size())
  {
    std::map<std::vector<unsigned int>, std::vector<unsigned int>> at_rim;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        normals.push_back(normal_of<dim>(faces[f].vertices, vertices));
        centers.push_back(center_of(faces[f].vertices, vertices));
        for (const auto &rim : rims_of<dim>(faces[f].vertices))
          at_rim[rim].push_back(f);
      }
    for (const auto &[rim, members] : at_rim)
      if (members.size() == 2)
        join(rim, members[0], members[1]);
  }



  template <int dim>
  void
  FacetGraph<dim>::join(const std::vector<unsigned int> &rim,
                        const unsigned int               a,
                        const unsigned int               b)
  {
    // Faces that go on straight lie opposite to each other.
    const double cosine =
      -(inward(rim, faces[a].vertices, vertices) * inward(rim, faces[b].vertices, vertices));
    if (cosine < std::cos(largest_angle * numbers::PI / 180))
      return;
    const double angle   = std::acos(std::min(1., cosine));
    double       sagitta = angle > 1e-5 ? centers[a].distance(centers[b]) * angle / 8 : 0.;
    // Halves of lines; of triangles the centers of which are half as far from each other as those
    // of squares.
    for (const unsigned int v : faces[a].vertices)
      if (inserted[v])
        {
          sagitta *= dim == 2 ? 2 : 4;
          break;
        }
    of_faces[a].push_back({b, sagitta});
    of_faces[b].push_back({a, sagitta});
  }



  template <int dim>
  double
  FacetGraph<dim>::sagitta(const std::vector<unsigned int> &some) const
  {
    double largest = 0;
    for (const unsigned int f : some)
      for (const Neighbour &n : of_faces[f])
        largest = std::max(largest, n.sagitta);
    return largest;
  }



  template class FacetGraph<2>;
  template class FacetGraph<3>;
} // namespace Signorini
