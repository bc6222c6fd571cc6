// SPDX-License-Identifier: Apache-2.0
#include "geometry/cell_rule.h"
#include "geometry/manifolds.h"
#include "geometry/simplex_nodes.h"

#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return the position of a node of MeshFile::Element in the lattice of 3^dim points, as ix +
    /// 3 iy + 9 iz.
    template <int dim>
    unsigned int
    lattice_point(const unsigned int node)
    {
      // Elements list the corners first, counterclockwise, then the middles of the edges, of the
      // faces, and the centre; the tables give the place of each of them in the lattice.
      if (dim == 2)
        return std::array<unsigned int, 9>{{0, 2, 8, 6, 1, 5, 7, 3, 4}}[node];
      return std::array<unsigned int, 27>{{0,  2,  8, 6,  18, 20, 26, 24, 1,  5,  7, 3,  19, 23,
                                           25, 21, 9, 11, 17, 15, 12, 14, 10, 16, 4, 22, 13}}[node];
    }



    /// @return the numbers 0, 1, 2 of a lattice point in each direction.
    template <int dim>
    std::array<unsigned int, dim>
    indices_of(unsigned int point)
    {
      std::array<unsigned int, dim> indices;
      for (unsigned int &index : indices)
        {
          index = point % 3;
          point /= 3;
        }
      return indices;
    }



    /// @return in how many directions the point is in the middle: 0 for corners, 1 for edges, 2 for
    /// faces, 3 for the centre.
    template <int dim>
    unsigned int
    n_middles(const unsigned int point)
    {
      unsigned int n = 0;
      for (const unsigned int index : indices_of<dim>(point))
        n += index == 1;
      return n;
    }



    /// @return whether point b is on the smallest edge, face or cell that contains a in its
    /// interior.
    template <int dim>
    bool
    is_around(const unsigned int a, const unsigned int b)
    {
      const auto i = indices_of<dim>(a), j = indices_of<dim>(b);
      for (unsigned int d = 0; d < dim; ++d)
        if (i[d] != 1 && i[d] != j[d])
          return false;
      return true;
    }



    /// @return the position of a lattice point that the corners alone define by the multilinear
    /// functions, or corners and edges by the serendipity functions.
    template <int dim>
    Point<dim>
    filled(const std::vector<Point<dim>> &points, const unsigned int a, const bool by_edges)
    {
      // Serendipity functions at the middle of a face: half of its four edges minus a quarter of
      // its four corners; at the centre of a hexahedron: a quarter of its twelve edges minus a
      // quarter of its eight corners. The factors of each add up to one.
      Point<dim>         sum;
      const unsigned int n_points = points.size(), m = n_middles<dim>(a);
      for (unsigned int b = 0; b < n_points; ++b)
        if (is_around<dim>(a, b))
          {
            if (n_middles<dim>(b) == 0)
              sum += (by_edges ? -0.25 : std::pow(0.5, m)) * points[b];
            else if (by_edges && n_middles<dim>(b) == 1)
              sum += (m == 2 ? 0.5 : 0.25) * points[b];
          }
      return sum;
    }



    /// @return the quadratic Lagrange functions of the nodes 0, 1/2, 1 at x; slopes() are their
    /// derivatives.
    std::array<double, 3>
    values(const double x)
    {
      return {{(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)}};
    }

    std::array<double, 3>
    slopes(const double x)
    {
      return {{4 * x - 3, 4 - 8 * x, 4 * x - 1}};
    }
  } // namespace



  template <int dim>
  QuadraticMap<dim>::QuadraticMap(const std::vector<Point<dim>> &nodes)
    : points(Utilities::pow(3, dim))
    , size(0)
  {
    // The nodes of the file go to their places in the lattice. The largest distance from the first
    // node is the length to which the tolerances of this class are relative.
    for (unsigned int node = 0; node < nodes.size(); ++node)
      {
        points[lattice_point<dim>(node)] = nodes[node];
        size                             = std::max(size, nodes[node].distance(nodes[0]));
      }
    // Serendipity elements (8 or 20 nodes) lack the middles of faces and the centre. These follow
    // from corners and edges, so that the complete quadratic map is the one of the file.
    for (unsigned int node = nodes.size(); node < points.size(); ++node)
      points[lattice_point<dim>(node)] = filled(points, lattice_point<dim>(node), true);
  }



  // The sum of all lattice points, each with the product of its polynomials along the directions.
  template <int dim>
  Point<dim>
  QuadraticMap<dim>::value(const Point<dim> &xi) const
  {
    std::array<std::array<double, 3>, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = values(xi[d]);
    Point<dim> x;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const auto i      = indices_of<dim>(p);
        double     weight = 1;
        for (unsigned int d = 0; d < dim; ++d)
          weight *= v[d][i[d]];
        x += weight * points[p];
      }
    return x;
  }



  // Products of one derivative and values in the other directions.
  template <int dim>
  Tensor<2, dim>
  QuadraticMap<dim>::gradient(const Point<dim> &xi) const
  {
    std::array<std::array<double, 3>, dim> v, s;
    for (unsigned int d = 0; d < dim; ++d)
      {
        v[d] = values(xi[d]);
        s[d] = slopes(xi[d]);
      }
    Tensor<2, dim> result;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const auto i = indices_of<dim>(p);
        for (unsigned int e = 0; e < dim; ++e)
          {
            double weight = 1;
            for (unsigned int d = 0; d < dim; ++d)
              weight *= d == e ? s[d][i[d]] : v[d][i[d]];
            for (unsigned int c = 0; c < dim; ++c)
              result[c][e] += weight * points[p][c];
          }
      }
    return result;
  }



  // Damped Newton iteration for x(xi) = x. It ends at rounding, when no step along the direction
  // reduces the residual, or after 50 steps.
  template <int dim>
  Point<dim>
  QuadraticMap<dim>::inverse(const Point<dim> &x) const
  {
    Point<dim> xi;
    for (unsigned int d = 0; d < dim; ++d)
      xi[d] = 0.5;
    // The lattice point closest to x is a start from which Newton's method converges.
    double nearest = x.distance(value(xi));
    for (unsigned int p = 0; p < points.size(); ++p)
      if (x.distance(points[p]) < nearest)
        {
          nearest      = x.distance(points[p]);
          const auto i = indices_of<dim>(p);
          for (unsigned int d = 0; d < dim; ++d)
            xi[d] = 0.5 * i[d];
        }

    Tensor<1, dim> residual = x - value(xi);
    for (unsigned int step = 0; step < 50 && residual.norm() > 1e-15 * size; ++step)
      {
        const Tensor<1, dim> direction = invert(gradient(xi)) * residual;
        // The step is halved until the residual decreases; at the level of rounding none does.
        double         factor = 1;
        Tensor<1, dim> next   = x - value(xi + direction);
        while (!(next.norm() < residual.norm()) && factor > 1e-3)
          {
            factor /= 2;
            next = x - value(xi + factor * direction);
          }
        if (!(next.norm() < residual.norm()))
          break;
        xi += factor * direction;
        residual = next;
      }
    // A residual that the iteration could not reduce is an error, unless it is the rounding of
    // coordinates far from the origin: x itself has only 16 digits there.
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * x.norm();
    if (residual.norm() > 1e-10 * size + rounding)
      {
        std::ostringstream place;
        place << x;
        throw std::runtime_error("A cell of second order has no point (" + place.str() +
                                 "): its shape cannot be inverted there.");
      }
    return xi;
  }



  // The middles of edges and faces, and the centre, are compared with the means of the corners
  // around them. Files have few digits, hence the tolerance of 1e-8 of the size of the cell.
  template <int dim>
  bool
  QuadraticMap<dim>::is_multilinear() const
  {
    for (unsigned int p = 0; p < points.size(); ++p)
      if (n_middles<dim>(p) > 0 && points[p].distance(filled(points, p, false)) > 1e-8 * size)
        return false;
    return true;
  }



  template <int dim>
  bool
  QuadraticMap<dim>::is_invertible() const
  {
    // The determinant of the gradient must have the same sign at all samples. A zero counts as both
    // signs. Samples between the nodes are necessary because the determinant of a quadratic map may
    // be positive at all nodes and negative between them.
    constexpr unsigned int n        = 5; // a direction: the nodes, and one between each two
    bool                   positive = false, negative = false;
    for (unsigned int p = 0; p < Utilities::pow(n, dim); ++p)
      {
        Point<dim> xi;
        for (unsigned int d = 0, rest = p; d < dim; ++d, rest /= n)
          xi[d] = (rest % n) / (n - 1.);
        const double volume = determinant(gradient(xi));
        positive |= volume >= 0;
        negative |= volume <= 0;
      }
    return positive != negative;
  }



  namespace
  {
    /// Barycentric coordinates of the points at which the shape of simplices is checked: nodes, and
    /// points between them.
    template <int dim>
    std::vector<std::array<double, dim + 1>>
    samples_of_simplex()
    {
      const FE_SimplexP<dim>  shapes(2);
      std::vector<Point<dim>> points = cell_rule<dim>(shapes.reference_cell(), 4).get_points();
      points.insert(points.end(),
                    shapes.get_unit_support_points().begin(),
                    shapes.get_unit_support_points().end());
      std::vector<std::array<double, dim + 1>> result;
      for (const Point<dim> &point : points)
        {
          result.emplace_back();
          for (unsigned int v = 0; v <= dim; ++v)
            result.back()[v] = shapes.reference_cell().d_linear_shape_function(point, v);
        }
      return result;
    }
  } // namespace



  // The derivatives of the map are linear, and follow from those at the vertices: along the edge
  // from vertex 0 to vertex d they are 4 (x_db - x_0b) - (x_d - x_0) at vertex b, with x_ab in the
  // middle of the edge from a to b, and x_aa = x_a.
  template <int dim>
  bool
  is_inverted_simplex(const std::vector<Point<dim>> &nodes)
  {
    static const auto samples = samples_of_simplex<dim>();
    const auto between = [&](const unsigned int a, const unsigned int b) -> const Point<dim> & {
      return nodes[node_between<dim>(a, b)];
    };
    std::array<Tensor<2, dim>, dim + 1> at_vertex; // [vertex][direction][component]
    for (unsigned int b = 0; b <= dim; ++b)
      for (unsigned int d = 0; d < dim; ++d)
        at_vertex[b][d] = 4 * (between(d + 1, b) - between(0, b)) - (nodes[d + 1] - nodes[0]);
    return std::any_of(samples.begin(), samples.end(), [&](const auto &weights) {
      Tensor<2, dim> slope;
      for (unsigned int b = 0; b <= dim; ++b)
        slope += weights[b] * at_vertex[b];
      return !(determinant(slope) > 0); // also NaN
    });
  }



  template bool
  is_inverted_simplex(const std::vector<Point<2>> &);
  template bool
  is_inverted_simplex(const std::vector<Point<3>> &);
  template class QuadraticMap<2>;
  template class QuadraticMap<3>;
  template class QuadraticManifold<2>;
  template class QuadraticManifold<3>;
} // namespace Signorini
