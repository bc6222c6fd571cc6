// SPDX-License-Identifier: Apache-2.0
#include "contact/search/segments.h"

#include <deal.II/base/utilities.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Set the center and the orthonormal axes of the mean plane of a facet (2D: its line). In
    /// space its normal is that of the cross product of the diagonals, which is the mean normal of
    /// the bilinear facet.
    template <int dim>
    void
    set_plane(Facet<dim> &facet)
    {
      const auto &x = facet.corners;
      auto       &t = facet.axes;
      if constexpr (dim == 2)
        {
          facet.center = (x[0] + x[1]) / 2.;
          t[0]         = (x[1] - x[0]) / x[0].distance(x[1]);
        }
      else
        {
          facet.center          = (x[0] + x[1] + x[2] + x[3]) / 4.;
          Tensor<1, dim> normal = cross_product_3d(x[3] - x[0], x[2] - x[1]);
          normal /= normal.norm();
          t[0] = x[1] - x[0];
          t[0] -= (t[0] * normal) * normal;
          t[0] /= t[0].norm();
          t[1] = cross_product_3d(normal, t[0]);
        }
    }

    /// The unit normal of the mean plane of a facet, oriented by its parameters.
    template <int dim>
    Tensor<1, dim>
    normal(const Facet<dim> &facet)
    {
      if constexpr (dim == 2)
        return cross_product_2d(facet.axes[0]);
      else
        return cross_product_3d(facet.axes[0], facet.axes[1]);
    }
  } // namespace



  template <int dim>
  FacetedFace<dim>::FacetedFace(const FacePatch<dim> &patch)
    : patch(patch)
  {
    // A face of degree k is divided into k facets in each direction, between neighbouring nodes.
    const unsigned int per_line = patch.get_degree(), n = Utilities::fixed_power<dim - 1>(per_line);
    for (unsigned int i = 0; i < n; ++i)
      {
        Facet<dim> facet;
        // Facets are numbered lexicographically, with the first parameter running fastest.
        for (unsigned int d = 0, rest = i; d < dim - 1; ++d, rest /= per_line)
          facet.place[d] = rest % per_line;
        for (unsigned int c = 0; c < facet.n_corners; ++c)
          {
            Point<dim - 1> xi;
            for (unsigned int d = 0; d < dim - 1; ++d)
              xi[d] = double(facet.place[d] + ((c >> d) & 1)) / per_line;
            facet.corners[c] = patch.position(xi);
          }
        set_plane(facet);
        facets.push_back(facet);
      }
  }



  template <int dim>
  BoundingBox<dim>
  FacetedFace<dim>::extruded_box(const double search_radius) const
  {
    // Extend the box of the face by the corners of the facets, displaced by the radius along their
    // normals in both directions.
    BoundingBox<dim> box = patch.box();
    for (const Facet<dim> &facet : facets)
      {
        const Tensor<1, dim> step = search_radius * normal(facet);
        for (const Point<dim> &corner : facet.corners)
          for (const Point<dim> &x : {corner + step, corner - step})
            box.merge_with(BoundingBox<dim>({x, x}));
      }
    return box;
  }



  template struct FacetedFace<2>;
  template struct FacetedFace<3>;
} // namespace Signorini
