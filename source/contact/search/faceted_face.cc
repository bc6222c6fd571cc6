// SPDX-License-Identifier: Apache-2.0
#include "contact/search/segments.h"
#include "geometry/face_functions.h"
#include "geometry/face_parameter.h"

#include <algorithm>
#include <cmath>

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
          Tensor<1, dim> sum;
          for (const Point<dim> &corner : x)
            sum += corner;
          facet.center          = Point<dim>(sum / double(x.size()));
          Tensor<1, dim> normal = x.size() == 3 ? cross_product_3d(x[1] - x[0], x[2] - x[0]) :
                                                  cross_product_3d(x[3] - x[0], x[2] - x[1]);
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

    /// True if the multilinear facet of the corners replaces those between all nodes. Segments are
    /// intersections in planes, so that only the deviation along the facet moves their boundaries,
    /// and one across it as far as the planes of both faces differ: on a sphere of radius R a face
    /// of size h deviates by h/(8 R) of its size, and neighbours of which only one is divided
    /// overlap by (h/R)^2/24 of it, which with this limit is less than what counts as covered
    /// twice.
    template <int dim>
    bool
    is_one_facet(const FacePatch<dim> &face)
    {
      constexpr double most_across = 5e-3, most_along = 1e-4;
      if (face.get_degree() == 1)
        return true;
      const ReferenceCell    &shape = face.reference_cell();
      const Tensor<1, dim>    n     = face.normal(face.middle());
      std::vector<Point<dim>> x;
      for (const Point<dim - 1> &corner : face_lattice<dim>(shape, 1))
        x.push_back(face.position(corner));
      for (const Point<dim - 1> &xi : face_lattice<dim>(shape, face.get_degree()))
        {
          const Tensor<1, dim> deviation =
            face.position(xi) -
            Point<dim>(
              FaceFunctions<dim>(shape, 1, xi).template derivative_of<Tensor<1, dim>>(x, {}));
          const double across = std::abs(deviation * n);
          if (across > most_across * face.diameter() ||
              (deviation - (deviation * n) * n).norm() > most_along * face.diameter())
            return false;
        }
      return true;
    }
  } // namespace



  template <int dim>
  Point<dim - 1>
  Facet<dim>::parameter_of_face(const ReferenceCell &shape, const Point<dim - 1> &s) const
  {
    Point<dim - 1> xi = origin;
    for (unsigned int d = 0; d < dim - 1; ++d)
      xi += s[d] * edges[d];
    return nearest_in_cell<dim - 1>(shape, xi);
  }



  template <int dim>
  std::optional<unsigned int>
  Facet<dim>::side_of_face(const ReferenceCell &shape, const unsigned int side) const
  {
    constexpr double rounding = 1e-9; // of parameters
    if constexpr (dim == 2)
      {
        // Side 0 or 1 of a line is where its parameter is that.
        if (std::abs(origin[0] + side * edges[0][0] - side) < rounding)
          return side;
      }
    else
      for (unsigned int of_face = 0; of_face < shape.n_faces(); ++of_face)
        {
          const auto         ends      = ends_of_side<dim>(shape, of_face);
          const Tensor<1, 2> way       = ends[1] - ends[0];
          const auto         is_beside = [&](const Point<2> &s) {
            const Tensor<1, 2> arm = (origin + s[0] * edges[0] + s[1] * edges[1]) - ends[0];
            return std::abs(way[0] * arm[1] - way[1] * arm[0]) > rounding;
          };
          const auto of_facet = ends_of_side<dim>(shape, side);
          if (std::none_of(of_facet.begin(), of_facet.end(), is_beside))
            return of_face;
        }
    return {};
  }



  template <int dim>
  FacetedFace<dim>::FacetedFace(const FacePatch<dim> &patch)
    : patch(patch)
  {
    // A face of degree k is divided between neighbouring nodes, into k facets in each direction,
    // if it has to be.
    // Of a triangle there are those from a node to the next ones along the parameters, and those
    // from there back.
    const ReferenceCell &shape = patch.reference_cell();
    const int            k     = is_one_facet(patch) ? 1 : patch.get_degree();
    const auto           add   = [&](const int i, const int j, const int step) {
      Facet<dim>         facet;
      std::array<int, 2> from{{i, j}};
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          facet.origin[d]   = double(from[d]) / k;
          facet.edges[d][d] = double(step) / k;
        }
      for (const unsigned int v : shape.vertex_indices())
        {
          // Parameters are quotients of integers, so that neighbours have the same corners.
          const Point<dim - 1> corner = shape.vertex<dim - 1>(v);
          Point<dim - 1>       xi;
          for (unsigned int d = 0; d < dim - 1; ++d)
            xi[d] = double(from[d] + step * std::lround(corner[d])) / k;
          facet.corners.push_back(patch.position(xi));
        }
      set_plane(facet);
      facets.push_back(facet);
    };
    // Facets are numbered lexicographically, with the first parameter running fastest.
    for (int j = 0; j < (dim == 3 ? k : 1); ++j)
      for (int i = 0; i < (is_triangle(shape) ? k - j : k); ++i)
        {
          add(i, j, 1);
          if (is_triangle(shape) && i + j + 2 <= k)
            add(i + 1, j + 1, -1);
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



  template struct Facet<2>;
  template struct Facet<3>;
  template struct FacetedFace<2>;
  template struct FacetedFace<3>;
} // namespace Signorini
