// SPDX-License-Identifier: Apache-2.0
#include "contact/search/descent.h"

#include "geometry/face_parameter.h"

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Quadratic model of f(xi) = |x(xi) - x|^2 / 2 around one parameter.
    template <int dim>
    struct QuadraticModel
    {
      Tensor<1, dim>                      residual; // x(xi) - x
      std::array<Tensor<1, dim>, dim - 1> tangents;
      Tensor<1, dim - 1>                  gradient;
      Tensor<2, dim - 1>                  hessian; // positive definite in any case
      bool                                convex;  // f itself is, as far as xi is free to move
    };

    /// The domain of the parameters of a face, a convex polygon (2D: an interval), as the
    /// inequalities normal . xi <= bound, one for each side.
    template <int n>
    struct Side
    {
      Tensor<1, n> normal;
      double       bound;
    };

    const std::vector<Side<1>> &
    sides_of(const ReferenceCell & /*line*/, const Point<1> &)
    {
      static const std::vector<Side<1>> line = {{Tensor<1, 1>({-1.}), 0.},
                                                {Tensor<1, 1>({1.}), 1.}};
      return line;
    }

    const std::vector<Side<2>> &
    sides_of(const ReferenceCell &shape, const Point<2> &)
    {
      static const std::vector<Side<2>> square   = {{Tensor<1, 2>({-1., 0.}), 0.},
                                                    {Tensor<1, 2>({1., 0.}), 1.},
                                                    {Tensor<1, 2>({0., -1.}), 0.},
                                                    {Tensor<1, 2>({0., 1.}), 1.}},
                                        triangle = {{Tensor<1, 2>({-1., 0.}), 0.},
                                                    {Tensor<1, 2>({0., -1.}), 0.},
                                                    {Tensor<1, 2>({1., 1.}), 1.}};
      return is_triangle(shape) ? triangle : square;
    }

    // Where a side of the domain is active, the curvature across it (and its coupling) has no
    // effect on the minimum, which is on that side: there the Gauss-Newton matrix is taken.
    template <int n>
    Tensor<2, n>
    without_constrained(Tensor<2, n>                hessian,
                        const Tensor<2, n>         &gauss_newton,
                        const Tensor<1, n>         &gradient,
                        const std::vector<Side<n>> &sides,
                        const Point<n>             &xi)
    {
      for (const auto &[normal, bound] : sides)
        if (normal * xi == bound && normal * gradient < 0)
          {
            // H = P H P + Q G Q with the projections P along the side and Q = 1 - P across it.
            const double       across_across = normal * (gauss_newton * normal);
            const Tensor<2, n> Q             = outer_product(normal, normal) / normal.norm_square(),
                               P             = unit_symmetric_tensor<n>() - Q;
            hessian = P * hessian * P + across_across / normal.norm_square() * Q;
          }
      return hessian;
    }

    // Gradient and Hessian (3.2); the Gauss-Newton matrix is positive definite wherever the
    // tangents are independent.
    template <int dim>
    QuadraticModel<dim>
    model_at(const Point<dim> &x, const FacePatch<dim> &face, const Point<dim - 1> &xi)
    {
      QuadraticModel<dim> m;
      const auto          geometry = face.at(xi, 2);
      m.residual                   = geometry.position - x;
      m.tangents                   = geometry.tangents;
      const auto &curvatures       = geometry.curvatures;

      Tensor<2, dim - 1> gauss_newton, hessian;
      for (unsigned int i = 0; i < dim - 1; ++i)
        {
          m.gradient[i] = m.residual * m.tangents[i];
          for (unsigned int j = 0; j < dim - 1; ++j)
            {
              gauss_newton[i][j] = m.tangents[i] * m.tangents[j];
              hessian[i][j]      = gauss_newton[i][j] + m.residual * curvatures[i][j];
            }
        }
      // On the concave side, beyond the centre of curvature, Newton would climb to a maximum.
      hessian = without_constrained(
        hessian, gauss_newton, m.gradient, sides_of(face.reference_cell(), xi), xi);
      m.convex = hessian[0][0] > 1e-10 * gauss_newton[0][0] &&
                 determinant(hessian) > 1e-10 * determinant(gauss_newton);
      m.hessian = m.convex ? hessian : gauss_newton;
      return m;
    }

    // The minimiser s of the quadratic model g.s + s.H.s/2 over the domain as seen from xi. It is
    // found exactly, so that active bounds need no bookkeeping.
    Tensor<1, 1>
    constrained_minimiser(const Tensor<1, 1> &g,
                          const Tensor<2, 1> &H,
                          const ReferenceCell & /*line*/,
                          const Point<1> &xi)
    {
      Tensor<1, 1> s;
      s[0] = std::clamp(-g[0] / H[0][0], -xi[0], 1 - xi[0]);
      return s;
    }

    Tensor<1, 2>
    constrained_minimiser(const Tensor<1, 2>  &g,
                          const Tensor<2, 2>  &H,
                          const ReferenceCell &shape,
                          const Point<2>      &xi)
    {
      const Tensor<1, 2> newton = -1. * (invert(H) * g);
      const auto        &sides  = sides_of(shape, xi);
      if (std::all_of(sides.begin(), sides.end(), [&](const auto &side) {
            return side.normal * newton <= side.bound - side.normal * xi;
          }))
        return newton;

      // A convex function whose minimum is outside takes its smallest value on one of the sides.
      Tensor<1, 2> best;
      double       best_value = std::numeric_limits<double>::max();
      for (unsigned int side = 0; side < shape.n_faces(); ++side)
        {
          const auto [from, to]  = ends_of_side<3>(shape, side);
          const Tensor<1, 2> way = to - from, start = from - xi;
          const double move    = std::clamp(-(way * (g + H * start)) / (way * (H * way)), 0., 1.);
          const Tensor<1, 2> s = start + move * way;
          const double       value = g * s + 0.5 * (s * (H * s));
          if (value < best_value)
            {
              best_value = value;
              best       = s;
            }
        }
      return best;
    }

    // The parameter after a step, in the domain also with rounding: bounds are compared exactly
    // later.
    template <int n>
    Point<n>
    moved(const ReferenceCell &shape, const Point<n> &xi, const Tensor<1, n> &step)
    {
      Point<n> result;
      for (unsigned int d = 0; d < n; ++d)
        {
          result[d] = std::clamp(xi[d] + step[d], 0., 1.);
          // What is 1 up to rounding is 1: a step to a corner of the domain arrives there.
          if (result[d] > 1 - 1e-15)
            result[d] = 1;
        }
      if constexpr (n == 2)
        if (is_triangle(shape) && result[0] + result[1] > 1 - 1e-15)
          result[1] = 1 - result[0]; // whose sum is 1 exactly
      return result;
    }

    // The rounding error of the positions involved [length].
    template <int dim>
    double
    rounding(const Point<dim> &x, const FacePatch<dim> &face)
    {
      return 8 * std::numeric_limits<double>::epsilon() * (x.norm() + face.diameter());
    }

    // One step from xi, halved until f does not increase (up to rounding); false if no step length
    // achieves that.
    template <int dim>
    bool
    descend(const Point<dim>          &x,
            const FacePatch<dim>      &face,
            const QuadraticModel<dim> &m,
            const Tensor<1, dim - 1>  &step,
            Point<dim - 1>            &xi)
    {
      const Point<dim> start = x + m.residual;
      const double     slack = rounding(x, face) * m.residual.norm();
      // Armijo's condition with 1e-4 of the predicted decrease. The slack admits steps whose change
      // of f is rounding, otherwise the last step before convergence could be refused.
      for (double damping = 1; damping > 1e-5; damping /= 2)
        {
          const Point<dim - 1> trial    = moved(face.reference_cell(), xi, damping * step);
          const Tensor<1, dim> movement = face.position(trial) - start;
          // f(trial) - f(xi) without the cancellation that two squares would bring
          const double change = movement * (m.residual + 0.5 * movement);
          if (change <= 1e-4 * damping * (m.gradient * step) + slack)
            {
              xi = trial;
              return true;
            }
        }
      return false;
    }
  } // namespace



  // Projected Newton method for (1.8) with the Hessian (3.2). Each step minimises the quadratic
  // model over the domain of the parameters exactly. It ends where a step moves the point by
  // rounding only; the result is a minimum if the model is convex there. At most 30 steps;
  // project() has other means where this fails.
  template <int dim>
  bool
  descend_to_minimum(const Point<dim> &x, const FacePatch<dim> &face, Point<dim - 1> &xi)
  {
    const double tolerance = 1e-12 * face.diameter() + rounding(x, face);
    for (unsigned int iteration = 0; iteration < 30; ++iteration)
      {
        const QuadraticModel<dim> m = model_at(x, face, xi);
        const Tensor<1, dim - 1>  step =
          constrained_minimiser(m.gradient, m.hessian, face.reference_cell(), xi);
        // The step in space, which unlike the parameters has a length to compare with the size of
        // the face.
        Tensor<1, dim> way;
        for (unsigned int d = 0; d < dim - 1; ++d)
          way += step[d] * m.tangents[d];
        if (way.norm() <= tolerance)
          {
            xi = moved(face.reference_cell(), xi, step);
            return m.convex;
          }
        if (!descend(x, face, m, step, xi))
          return false;
      }
    return false;
  }


  template bool
  descend_to_minimum<2>(const Point<2> &, const FacePatch<2> &, Point<1> &);
  template bool
  descend_to_minimum<3>(const Point<3> &, const FacePatch<3> &, Point<2> &);
} // namespace Signorini
