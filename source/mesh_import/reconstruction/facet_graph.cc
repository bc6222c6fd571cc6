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

    /// The unit normal of a face. A quadrilateral need not be plane: its normal is that of both
    /// diagonals.
    template <int dim>
    Tensor<1, dim>
    normal_of(const std::vector<unsigned int> &v, const std::vector<Point<dim>> &vertices)
    {
      Tensor<1, dim> n;
      if constexpr (dim == 2)
        n = cross_product_2d(vertices[v[1]] - vertices[v[0]]);
      else if (v.size() == 3)
        n = cross_product_3d(vertices[v[1]] - vertices[v[0]], vertices[v[2]] - vertices[v[0]]);
      else
        n = cross_product_3d(vertices[v[3]] - vertices[v[0]], vertices[v[2]] - vertices[v[1]]);
      return n / n.norm();
    }
  } // namespace



  // Faces are neighbours where exactly two of them have a rim (2D: a vertex, 3D: an edge) in
  // common. At a rim of three or more faces, where surfaces branch, no two of them continue each
  // other. Cost: O(n log n) for n faces.
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
    // The inward directions of two faces that continue each other in one plane are opposite: minus
    // their product is the cosine of the angle by which the surface bends at the rim.
    const double cosine =
      -(inward(rim, faces[a].vertices, vertices) * inward(rim, faces[b].vertices, vertices));
    if (cosine < std::cos(largest_angle * numbers::PI / 180))
      return;
    // The sagitta of a chord of length L that spans the angle a of a circle is L a/8 to leading
    // order; the distance between the centres of the faces is taken for L. Below 1e-5 the angle is
    // rounding of the coordinates.
    const double angle   = std::acos(std::min(1., cosine));
    double       sagitta = angle > 1e-5 ? centers[a].distance(centers[b]) * angle / 8 : 0.;
    // Faces with inserted vertices are parts of facets of the file, and the sagitta wanted is that
    // of the whole facet. In 2D the parts are halves of lines. In 3D they are quadrilaterals cut
    // from triangles, whose centres are half as far from each other as those of squares; so are
    // those of triangles. The sagitta grows with the square of the length, of which the angle
    // already contains one factor.
    const auto &v = faces[a].vertices;
    if ((dim == 3 && v.size() == 3) ||
        std::any_of(v.begin(), v.end(), [&](const unsigned int i) { return inserted[i]; }))
      sagitta *= dim == 2 ? 2 : 4;
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
