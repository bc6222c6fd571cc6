// SPDX-License-Identifier: Apache-2.0
#include "geometry/manifolds.h"

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  // A straight line: with both tangents equal to the chord, the cubic terms cancel and the
  // parameter is proportional to the arc length.
  template <int dim>
  CubicCurve<dim>::CubicCurve(const Point<dim> &from, const Point<dim> &to)
    : from(from)
    , to(to)
    , start(to - from)
    , end(to - from)
  {}



  template <int dim>
  CubicCurve<dim>::CubicCurve(const Point<dim>     &from,
                              const Point<dim>     &to,
                              const Tensor<1, dim> &start,
                              const Tensor<1, dim> &end)
    : from(from)
    , to(to)
  {
    // An arc of angle t and radius R has the chord 2 R sin(t/2) and, for the best Hermite
    // interpolant, tangents of length 4 R tan(t/4), at angles of t/2 to the chord.
    const Tensor<1, dim> chord  = to - from;
    const double         cosine = (start + end) * chord / (2 * chord.norm()),
                 length         = 2 * chord.norm() / (1 + cosine);
    this->start                 = length * start;
    this->end                   = length * end;
  }



  // The Hermite interpolant: both end points with their weights t^2 (3 - 2 t) and the rest to one,
  // and both tangents with s^2 t and - s t^2, where s = 1 - t. The derivative below is that of the
  // same four polynomials.
  template <int dim>
  Point<dim>
  CubicCurve<dim>::value(const double t) const
  {
    const double s = 1 - t;
    return from + t * t * (3 - 2 * t) * (to - from) + s * s * t * start - s * t * t * end;
  }



  template <int dim>
  Tensor<1, dim>
  CubicCurve<dim>::derivative(const double t) const
  {
    const double s = 1 - t;
    return 6 * s * t * (to - from) + s * (1 - 3 * t) * start - t * (2 - 3 * t) * end;
  }



  // The Coons patch: the sum of both linear interpolations between opposite edges minus the
  // bilinear interpolation of the corners.
  template <int dim>
  Point<dim>
  CurvedFace<dim>::push_forward(const Point<dim - 1> &xi) const
  {
    if constexpr (dim == 2)
      return edges[0].value(xi[0]);
    else
      {
        const double   x = xi[0], y = xi[1];
        Tensor<1, dim> result = (1 - x) * edges[0].value(y) + x * edges[1].value(y) +
                                (1 - y) * edges[2].value(x) + y * edges[3].value(x);
        // The corners are in both interpolations, so that one of the two is subtracted. They are
        // the ends of the edges 2 and 3, whose parameter is x.
        for (const unsigned int i : {0, 1})
          result -= (1 - y) * (i == 0 ? 1 - x : x) * edges[2].value(i) +
                    y * (i == 0 ? 1 - x : x) * edges[3].value(i);
        return Point<dim>(result);
      }
  }



  // The derivative of the Coons patch, column by column.
  template <int dim>
  DerivativeForm<1, dim - 1, dim>
  CurvedFace<dim>::push_forward_gradient(const Point<dim - 1> &xi) const
  {
    std::array<Tensor<1, dim>, dim - 1> columns;
    if constexpr (dim == 2)
      columns[0] = edges[0].derivative(xi[0]);
    else
      {
        const double     x = xi[0], y = xi[1];
        const Point<dim> c00 = edges[2].value(0), c10 = edges[2].value(1), c01 = edges[3].value(0),
                         c11 = edges[3].value(1);
        columns[0] = edges[1].value(y) - edges[0].value(y) + (1 - y) * edges[2].derivative(x) +
                     y * edges[3].derivative(x) - (1 - y) * (c10 - c00) - y * (c11 - c01);
        columns[1] = (1 - x) * edges[0].derivative(y) + x * edges[1].derivative(y) +
                     edges[3].value(x) - edges[2].value(x) - (1 - x) * (c01 - c00) -
                     x * (c11 - c10);
      }
    DerivativeForm<1, dim - 1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim - 1; ++e)
        result[d][e] = columns[e][d];
    return result;
  }



  template <int dim>
  Point<dim - 1>
  CurvedFace<dim>::pull_back(const Point<dim> &x) const
  {
    // Gauss-Newton from the nearest of some sample points, which is close since the face bends
    // little; parameters are limited to a range beyond the face.
    // The samples make the start unique; from the middle of the face alone, the iteration could end
    // at a point on the far side of a strongly curved face.
    constexpr unsigned int n = 5;
    Point<dim - 1>         xi;
    double                 least = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < (dim == 2 ? n : n * n); ++i)
      {
        Point<dim - 1> there;
        for (unsigned int d = 0, rest = i; d < dim - 1; ++d, rest /= n)
          there[d] = (rest % n) / (n - 1.);
        if (const double distance = push_forward(there).distance(x); distance < least)
          {
            least = distance;
            xi    = there;
          }
      }
    // Gauss-Newton omits the second derivatives times the distance, which vanishes for points on
    // the face: convergence there is quadratic. It ends if the parameters change by rounding only,
    // or if the step is not a number, which the negated comparison detects too.
    for (unsigned int step = 0; step < 30; ++step)
      {
        const Tensor<1, dim>                  rest = x - push_forward(xi);
        const DerivativeForm<1, dim - 1, dim> J    = push_forward_gradient(xi);
        Tensor<2, dim - 1>                    normal_matrix;
        Tensor<1, dim - 1>                    rhs;
        for (unsigned int e = 0; e < dim - 1; ++e)
          for (unsigned int d = 0; d < dim; ++d)
            {
              rhs[e] += J[d][e] * rest[d];
              for (unsigned int f = 0; f < dim - 1; ++f)
                normal_matrix[e][f] += J[d][e] * J[d][f];
            }
        const Tensor<1, dim - 1> change = invert(normal_matrix) * rhs;
        for (unsigned int e = 0; e < dim - 1; ++e)
          xi[e] = std::clamp(xi[e] + change[e], -0.5, 1.5);
        if (!(change.norm() > 1e-14))
          break;
      }
    return xi;
  }



  template class CubicCurve<2>;
  template class CubicCurve<3>;
  template class CurvedFace<2>;
  template class CurvedFace<3>;
} // namespace Signorini
