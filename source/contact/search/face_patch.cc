// SPDX-License-Identifier: Apache-2.0
#include "contact/search/face_patch.h"

#include "geometry/face_functions.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The vector product of the tangents (2D: the tangent rotated clockwise). Its length is the
    /// Jacobian of the parametrisation; its sign relative to the outward normal is
    /// FacePatch::get_outward().
    template <int dim>
    Tensor<1, dim>
    parametric_normal(const std::array<Tensor<1, dim>, dim - 1> &tangents)
    {
      if constexpr (dim == 2)
        return cross_product_2d(tangents[0]);
      else
        return cross_product_3d(tangents[0], tangents[1]);
    }

    /// The nodes of a face of a cell under the mapping, in the order of face_lattice().
    /// @param k degree of the geometry
    template <int dim>
    std::vector<Point<dim>>
    face_nodes(const Mapping<dim>                                      &mapping,
               const unsigned int                                       k,
               const typename Triangulation<dim>::active_cell_iterator &cell,
               const unsigned int                                       face)
    {
      const ReferenceCell     reference = cell->reference_cell();
      std::vector<Point<dim>> nodes;
      for (const Point<dim - 1> &xi : face_lattice<dim>(shape_of_faces(reference), k))
        nodes.push_back(
          mapping.transform_unit_to_real_cell(cell, unit_point<dim>(reference, face, xi)));
      return nodes;
    }

    /// Bound of the largest absolute value of a polynomial of degree k on a face over its largest
    /// nodal value: the Lebesgue constant of equidistant nodes, of tensor products, or 5/3 of
    /// degree 2 on triangles.
    template <int dim>
    double
    lebesgue_bound(const ReferenceCell &shape, const unsigned int k)
    {
      // By the degree, from 0 on; rounded up.
      constexpr std::array<double, max_degree + 1> line = {{1., 1., 1.25, 1.64, 2.21}};
      if (is_triangle(shape))
        return k == 1 ? 1. : 1.67;
      return Utilities::fixed_power<dim - 1>(line[k]);
    }

    /// The largest deviation of the nodes from the (multi)linear interpolant of the corners, by
    /// component [length]. The face is that interpolant, which stays in the box of its corners,
    /// plus a polynomial with these deviations as nodal values, which lebesgue_bound() limits.
    template <int dim>
    Tensor<1, dim>
    largest_deviation(const ReferenceCell           &shape,
                      const std::vector<Point<dim>> &nodes,
                      const unsigned int             k)
    {
      const std::vector<Point<dim>> corners = every_nth_of_lattice(shape, nodes, k, k);
      Tensor<1, dim>                largest;
      auto                          node = nodes.begin();
      for (const Point<dim - 1> &xi : face_lattice<dim>(shape, k))
        {
          const Tensor<1, dim> linear =
            FaceFunctions<dim>(shape, 1, xi).template derivative_of<Tensor<1, dim>>(corners, {});
          for (unsigned int d = 0; d < dim; ++d)
            largest[d] = std::max(largest[d], std::abs((*node)[d] - linear[d]));
          ++node;
        }
      return largest;
    }

    /// A bounding box of the face: that of its corners, extended by the bound of the deviation from
    /// the multilinear interpolant and by the rounding of coordinates. It encloses the face, while
    /// the box of the nodes alone might not where the face is curved.
    template <int dim>
    BoundingBox<dim>
    box_of(const ReferenceCell &shape, const std::vector<Point<dim>> &nodes, const unsigned int k)
    {
      const Tensor<1, dim> deviation =
        k == 1 ? Tensor<1, dim>() : largest_deviation(shape, nodes, k);
      BoundingBox<dim> box(k == 1 ? nodes : every_nth_of_lattice(shape, nodes, k, k));
      auto &[lower, upper]  = box.get_boundary_points();
      const double rounding = 1e-14 * (lower.norm() + upper.norm());
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double margin = lebesgue_bound<dim>(shape, k) * deviation[d] + rounding;
          lower[d] -= margin;
          upper[d] += margin;
        }
      return box;
    }
  } // namespace



  template <int dim>
  FacePatch<dim>::FacePatch(const unsigned int             degree,
                            const std::vector<Point<dim>> &nodes,
                            const double                   outward)
    : degree(degree)
    , nodes(nodes)
    , outward(outward)
  {
    measure();
  }



  template <int dim>
  FacePatch<dim>
  FacePatch<dim>::moved(const std::function<Point<dim>(const Point<dim> &)> &motion) const
  {
    FacePatch result = *this;
    std::transform(nodes.begin(), nodes.end(), result.nodes.begin(), motion);
    result.measure();
    return result;
  }



  template <int dim>
  FacePatch<dim>::FacePatch(const Mapping<dim>                                      &mapping,
                            const unsigned int                                       degree,
                            const typename Triangulation<dim>::active_cell_iterator &cell,
                            const unsigned int                                       face)
    : degree(geometry_degree_of(cell->reference_cell(), degree))
    , nodes(face_nodes(mapping, this->degree, cell, face))
  {
    measure();

    // A step into the cell along the third coordinate line leaves the face to the inside wherever
    // the mapping is valid; the center of a flat or strongly curved cell may lie on the wrong side.
    const Parameter  middle  = this->middle();
    const Point<dim> on_face = unit_point<dim>(cell->reference_cell(), face, middle);
    const Point<dim> inside  = on_face + 1e-3 * inward_direction<dim>(cell->reference_cell(), face);
    const Tensor<1, dim> outwards = mapping.transform_unit_to_real_cell(cell, on_face) -
                                    mapping.transform_unit_to_real_cell(cell, inside);
    outward = parametric_normal<dim>(tangents(middle)) * outwards > 0 ? 1. : -1.;
  }



  template <int dim>
  void
  FacePatch<dim>::measure()
  {
    Assert(degree >= 1 && degree <= max_degree, ExcIndexRange(degree, 1, max_degree + 1));
    shape = shape_of_lattice(dim, degree, nodes.size());
    AssertDimension(nodes.size(), face_lattice<dim>(shape, degree).size());

    size = 0;
    // The size is the largest distance of two nodes. A face of higher degree whose nodes are those
    // of a multilinear one to rounding is reduced to its corners: the search evaluates few things
    // more often than positions on faces.
    for (const Point<dim> &a : nodes)
      for (const Point<dim> &b : nodes)
        size = std::max(size, a.distance(b));
    bounds = box_of(shape, nodes, degree);
    const double rounding =
      1e-12 * size + 16 * std::numeric_limits<double>::epsilon() * nodes[0].norm();
    if (degree > 1 && largest_deviation(shape, nodes, degree).norm() < rounding)
      {
        nodes  = every_nth_of_lattice(shape, nodes, degree, degree);
        degree = 1;
      }

    // Estimate the largest norm of the second derivatives from the corners, the middles of the
    // sides and the center. They are polynomials of low degree, which rise little between these
    // points; a margin of a quarter is added. Lines and triangles of degree 1 have none.
    constexpr double margin = 1.25;
    largest_curvature       = 0;
    if (degree == 1)
      {
        // That of a bilinear face is constant, and has two equal entries.
        if (shape == ReferenceCells::Quadrilateral)
          largest_curvature =
            margin * std::sqrt(2.) * ((nodes[0] - nodes[1]) + (nodes[3] - nodes[2])).norm();
        return;
      }
    for (const Parameter &xi : face_lattice<dim>(shape, 2))
      {
        double square = 0;
        for (const auto &row : curvatures(xi))
          for (const Tensor<1, dim> &one : row)
            square += one.norm_square();
        largest_curvature = std::max(largest_curvature, margin * std::sqrt(square));
      }
  }



  // Sums of nodes times Lagrange polynomials (equation 3.1), or times their derivatives. Lines,
  // quadrilaterals and triangles of degree 1 are the faces of most meshes, and most of a search is
  // these sums: they are written out.
  template <int dim>
  FaceGeometry<dim>
  FacePatch<dim>::at(const Parameter &xi, const unsigned int n_derivatives) const
  {
    FaceGeometry<dim> result;
    if (degree == 1)
      {
        if constexpr (dim == 2)
          {
            result.position    = Point<dim>((1 - xi[0]) * nodes[0] + xi[0] * nodes[1]);
            result.tangents[0] = nodes[1] - nodes[0];
          }
        else if (is_triangle(shape))
          {
            result.position =
              Point<dim>((1 - xi[0] - xi[1]) * nodes[0] + xi[0] * nodes[1] + xi[1] * nodes[2]);
            result.tangents = {{nodes[1] - nodes[0], nodes[2] - nodes[0]}};
          }
        else
          {
            const double x = xi[0], y = xi[1];
            result.position         = Point<dim>((1 - y) * ((1 - x) * nodes[0] + x * nodes[1]) +
                                         y * ((1 - x) * nodes[2] + x * nodes[3]));
            result.tangents         = {{(1 - y) * (nodes[1] - nodes[0]) + y * (nodes[3] - nodes[2]),
                                        (1 - x) * (nodes[2] - nodes[0]) + x * (nodes[3] - nodes[1])}};
            result.curvatures[0][1] = (nodes[3] - nodes[2]) - (nodes[1] - nodes[0]);
            result.curvatures[1][0] = result.curvatures[0][1];
          }
        return result;
      }
    const FaceFunctions<dim> basis(shape, degree, xi);
    const auto               derivative = [&](const std::array<unsigned int, dim - 1> &orders) {
      return basis.template derivative_of<Tensor<1, dim>>(nodes, orders);
    };
    result.position = Point<dim>(derivative({}));
    for (unsigned int i = 0; i < dim - 1 && n_derivatives > 0; ++i)
      {
        std::array<unsigned int, dim - 1> orders{};
        orders[i]          = 1;
        result.tangents[i] = derivative(orders);
        for (unsigned int j = 0; j <= i && n_derivatives > 1; ++j)
          {
            auto second = orders;
            ++second[j];
            result.curvatures[i][j] = result.curvatures[j][i] = derivative(second);
          }
      }
    return result;
  }



  template <int dim>
  Point<dim>
  FacePatch<dim>::position(const Parameter &xi) const
  {
    return at(xi, 0).position;
  }



  template <int dim>
  std::array<Tensor<1, dim>, dim - 1>
  FacePatch<dim>::tangents(const Parameter &xi) const
  {
    return at(xi, 1).tangents;
  }



  template <int dim>
  std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1>
  FacePatch<dim>::curvatures(const Parameter &xi) const
  {
    return at(xi, 2).curvatures;
  }



  template <int dim>
  Tensor<1, dim>
  FacePatch<dim>::normal(const Parameter &xi) const
  {
    const Tensor<1, dim> n = outward * parametric_normal<dim>(tangents(xi));
    return n / n.norm();
  }



  template <int dim>
  double
  FacePatch<dim>::jacobian(const Parameter &xi) const
  {
    return parametric_normal<dim>(tangents(xi)).norm();
  }



  template <int dim>
  unsigned int
  FacePatch<dim>::get_degree() const
  {
    return degree;
  }



  template <int dim>
  const BoundingBox<dim> &
  FacePatch<dim>::box() const
  {
    return bounds;
  }



  template <int dim>
  double
  FacePatch<dim>::diameter() const
  {
    return size;
  }



  template <int dim>
  double
  FacePatch<dim>::second_derivative_bound() const
  {
    return largest_curvature;
  }



  // The mean of the nodes, which may lie beside a curved face; it is used in searches by distance
  // only.
  template <int dim>
  Point<dim>
  FacePatch<dim>::center() const
  {
    Tensor<1, dim> sum;
    for (const Point<dim> &node : nodes)
      sum += node;
    return Point<dim>(sum / double(nodes.size()));
  }



  template class FacePatch<2>;
  template class FacePatch<3>;
} // namespace Signorini
