// SPDX-License-Identifier: Apache-2.0
#include "mesh/transformed_manifold.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return whether all components are finite numbers.
    template <int dim>
    bool
    has_finite_components(const Tensor<1, dim> &v)
    {
      return std::isfinite(v.norm());
    }



    /// @return the coordinates of a point for messages.
    template <int dim>
    std::string
    text(const Point<dim> &p)
    {
      std::ostringstream out;
      out << '(' << p << ')';
      return out.str();
    }
  } // namespace



  // Images of all points, sorted for nearest().
  template <int dim>
  InvertibleMap<dim>::InvertibleMap(const VectorExpression<dim>   &F,
                                    const std::vector<Point<dim>> &points)
    : F(F)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (!F.prescribed(d))
        throw SceneError("the transformation '" + F.text() +
                         "' leaves a component free; give all " + std::to_string(dim));
    for (const Point<dim> &X : points)
      {
        pairs.push_back({value(X), X});
        if (!has_finite_components(pairs.back().image))
          throw SceneError("the transformation '" + F.text() + "' has no value at " + text(X));
        X_size = std::max(X_size, X.distance(points[0]));
        x_size = std::max(x_size, pairs.back().image.norm());
        middle += X / double(points.size());
      }
    std::sort(pairs.begin(), pairs.end(), [](const Pair &a, const Pair &b) {
      return a.image[0] < b.image[0];
    });
  }



  template <int dim>
  Point<dim>
  InvertibleMap<dim>::value(const Point<dim> &X) const
  {
    return Point<dim>(F.value(X));
  }



  // The affine map through the images of a corner of the bounding box and its edges is compared
  // with F at the points and at many others.
  template <int dim>
  bool
  InvertibleMap<dim>::is_affine() const
  {
    constexpr double       rounding = 1e-12, of_numbers = 1e-14; // of the box, of coordinates
    constexpr unsigned int n_between = 4096;
    Point<dim>             low = pairs[0].X, high = low;
    for (const Pair &pair : pairs)
      for (unsigned int d = 0; d < dim; ++d)
        {
          low[d]  = std::min(low[d], pair.X[d]);
          high[d] = std::max(high[d], pair.X[d]);
        }
    const Point<dim> shift = value(low);
    Tensor<2, dim>   linear; // columns: images of the box's edges
    double           span = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const Tensor<1, dim> edge =
          value(low + (high[d] - low[d]) * Point<dim>::unit_vector(d)) - shift;
        for (unsigned int c = 0; c < dim; ++c)
          linear[c][d] = edge[c] / (high[d] - low[d]);
        span += edge.norm();
      }
    const auto agrees = [&](const Point<dim> &X) {
      return (value(X) - shift - linear * (X - low)).norm() <=
             rounding * span + of_numbers * x_size;
    };
    // A sequence of points that is equidistributed but on no regular grid: multiples of irrational
    // numbers modulo one (Weyl).
    const double irrational[3] = {std::sqrt(2.), std::sqrt(3.), std::sqrt(5.)};
    for (unsigned int i = 1; i <= n_between; ++i)
      {
        Point<dim> X;
        for (unsigned int d = 0; d < dim; ++d)
          X[d] = low[d] + (high[d] - low[d]) * std::fmod(i * irrational[d], 1.);
        if (!agrees(X))
          return false;
      }
    return std::all_of(pairs.begin(), pairs.end(), [&](const Pair &pair) {
      return agrees(pair.X);
    });
  }



  // Columns by central differences.
  template <int dim>
  Tensor<2, dim>
  InvertibleMap<dim>::gradient(const Point<dim> &X) const
  {
    // Truncation of order h^2 is balanced against rounding of order 1e-16/h; Newton's method needs
    // no more.
    const double   h = 1e-5 * X_size;
    Tensor<2, dim> gradient;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const Tensor<1, dim> step  = h * Point<dim>::unit_vector(d);
        Point<dim>           ahead = X + step, behind = X - step;
        // At the boundary of the domain of the formulas one-sided differences are used.
        if (!has_finite_components(value(ahead)))
          ahead = X;
        if (!has_finite_components(value(behind)))
          behind = X;
        const Tensor<1, dim> column = (value(ahead) - value(behind)) / (ahead[d] - behind[d]);
        for (unsigned int i = 0; i < dim; ++i)
          gradient[i][d] = column[i];
      }
    return gradient;
  }



  template <int dim>
  const typename InvertibleMap<dim>::Pair &
  InvertibleMap<dim>::nearest(const Point<dim> &x) const
  {
    // The pairs are sorted by the first coordinate of their images: search in both directions until
    // this coordinate alone is farther than the closest image.
    const auto start =
      std::lower_bound(pairs.begin(), pairs.end(), x[0], [](const Pair &p, double x0) {
        return p.image[0] < x0;
      });
    auto   best     = start == pairs.end() ? start - 1 : start;
    double distance = x.distance(best->image);
    for (auto p = start; p != pairs.end() && p->image[0] - x[0] < distance; ++p)
      if (x.distance(p->image) < distance)
        {
          best     = p;
          distance = x.distance(p->image);
        }
    for (auto p = start; p != pairs.begin() && x[0] - (p - 1)->image[0] < distance; --p)
      if (x.distance((p - 1)->image) < distance)
        {
          best     = p - 1;
          distance = x.distance(best->image);
        }
    return *best;
  }



  // It ends at rounding, at a singular gradient, or when no step reduces the residual.
  template <int dim>
  std::optional<Point<dim>>
  InvertibleMap<dim>::solve(const Point<dim> &x, Point<dim> X) const
  {
    Tensor<1, dim> residual = x - value(X);
    for (unsigned int step = 0; step < 50 && residual.norm() > 1e-14 * x_size; ++step)
      {
        const Tensor<2, dim> slope = gradient(X);
        if (!(std::abs(determinant(slope)) > 0))
          break;
        const Tensor<1, dim> direction = invert(slope) * residual;
        // The step is halved until the residual decreases; at the level of rounding none does.
        double         factor = 1;
        Tensor<1, dim> next   = x - value(X + direction);
        while (!(next.norm() < residual.norm()) && factor > 1e-3)
          {
            factor /= 2;
            next = x - value(X + factor * direction);
          }
        if (!(next.norm() < residual.norm()))
          break;
        X += factor * direction;
        residual = next;
      }
    return residual.norm() > 1e-11 * x_size ? std::optional<Point<dim>>() : X;
  }



  template <int dim>
  Point<dim>
  InvertibleMap<dim>::inverse(const Point<dim> &x) const
  {
    // The map may be singular at a point of the boundary, for example where a corner is mapped to a
    // point of a circle: then the iteration starts slightly inside.
    const Point<dim> &start = nearest(x).X;
    for (const double share : {0., 0.02, 0.1, 0.3})
      if (const auto X = solve(x, start + share * (middle - start)))
        return *X;
    throw std::runtime_error(
      "The transformation '" + F.text() + "' cannot be inverted: no point near the mesh goes to " +
      text(x) +
      "; it must be one to one, also slightly outside of the mesh; a finer coarse mesh may help");
  }



  template class InvertibleMap<2>;
  template class InvertibleMap<3>;
} // namespace Signorini
