// SPDX-License-Identifier: Apache-2.0
#include "contact/search/projection.h"

#include "contact/search/descent.h"
#include "geometry/face_parameter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Parameter number n of a grid with per_line points a line over center +- half_width, clamped
    // to the square.
    template <int n_parameters>
    Point<n_parameters>
    grid_point(unsigned int               n,
               const unsigned int         per_line,
               const Point<n_parameters> &center,
               const double               half_width)
    {
      Point<n_parameters> xi;
      for (unsigned int d = 0; d < n_parameters; ++d, n /= per_line)
        xi[d] =
          std::clamp(center[d] + half_width * (2. * (n % per_line) / (per_line - 1) - 1), 0., 1.);
      return xi;
    }

    // Shrinking grid search, which needs only values: for points near the centre of curvature,
    // where the Hessian is singular.
    template <int dim>
    void
    grid_search(const Point<dim>     &x,
                const FacePatch<dim> &face,
                double                half_width,
                Point<dim - 1>       &xi)
    {
      // The grid is centred at the best point so far, and shrinks by 0.6 a round: about 60 rounds
      // from the spacing of the samples to 1e-13. Points of a grid are half of its half width
      // apart; with a factor above one half the next grid reaches beyond the neighbours of the best
      // point.
      double best = x.distance_square(face.position(xi));
      for (; half_width > 1e-13; half_width *= 0.6)
        {
          const Point<dim - 1> center = xi;
          for (unsigned int n = 0; n < (dim == 3 ? 25 : 5); ++n)
            {
              const Point<dim - 1> trial =
                nearest_in_cell(face.reference_cell(), grid_point(n, 5, center, half_width));
              const double value = x.distance_square(face.position(trial));
              if (value < best)
                {
                  best = value;
                  xi   = trial;
                }
            }
        }
    }

    // A Newton step after the grid search: values alone determine a parameter only up to the square
    // root of the rounding error.
    template <int dim>
    void
    polish(const Point<dim> &x, const FacePatch<dim> &face, Point<dim - 1> &xi)
    {
      Point<dim - 1> better = xi;
      if (descend_to_minimum(x, face, better) &&
          x.distance(face.position(better)) <=
            x.distance(face.position(xi)) + 1e-12 * face.diameter())
        xi = better;
    }

    /// The smallest singular value of the tangents in the middle of the face.
    template <int dim>
    double
    least_stretch(const FacePatch<dim> &face)
    {
      const auto t = face.tangents(face.middle());
      if constexpr (dim == 2)
        return t[0].norm();
      else
        {
          const double a = t[0].norm_square(), b = t[0] * t[1], c = t[1].norm_square();
          return std::sqrt(std::max(0., (a + c) / 2 - std::hypot((a - c) / 2, b)));
        }
    }

    // A grid of parameters on the face, with the squared distance at each of them, from whose local
    // minima Newton's method starts. A curved face can have several local minima; the density was
    // determined by experiments with very bumpy faces. Faces whose normals differ by less than a
    // radian have no bumps: as many points as nodes suffice.
    template <int dim>
    class Samples
    {
    public:
      /// @param stretch see least_stretch()
      Samples(const Point<dim> &x, const FacePatch<dim> &face, const double stretch)
        : per_line((face.second_derivative_bound() < stretch ? 1 : (dim == 2 ? 4 : 3)) *
                     face.get_degree() +
                   1)
        , count(dim == 3 ? per_line * per_line : per_line)
      {
        // Of the grid on the square a triangle has the points below the diagonal.
        const bool is_half = is_triangle(face.reference_cell());
        for (unsigned int n = 0; n < count; ++n)
          values[n] = is_half && n % per_line + n / per_line >= per_line ?
                        std::numeric_limits<double>::max() :
                        x.distance_square(face.position(parameter(n)));
      }

      unsigned int
      size() const
      {
        return count;
      }

      Point<dim - 1>
      parameter(const unsigned int n) const
      {
        Point<dim - 1> center;
        for (unsigned int d = 0; d < dim - 1; ++d)
          center[d] = 0.5;
        return grid_point(n, per_line, center, 0.5);
      }

      double
      spacing() const
      {
        return 1. / (per_line - 1);
      }

      // Compared along grid lines only: in a narrow diagonal valley this yields some starts more
      // than diagonal neighbours would allow. Of equal neighbours (a point on a plane of symmetry)
      // the first one counts.
      bool
      is_local_minimum(const unsigned int n) const
      {
        if (values[n] == std::numeric_limits<double>::max())
          return false;
        for (unsigned int d = 0, stride = 1; d < dim - 1; ++d, stride *= per_line)
          {
            const unsigned int i = n / stride % per_line;
            if (i > 0 && values[n - stride] <= values[n])
              return false;
            if (i + 1 < per_line && values[n + stride] < values[n])
              return false;
          }
        return true;
      }

    private:
      unsigned int            per_line, count;
      std::array<double, 169> values;
    };

    /// True if the Hessian of |x(xi) - x|^2/2, J^T J + (x(xi) - x) . d^2x, is positive definite on
    /// the whole face: then there is one minimum, which Newton's method finds from any start.
    template <int dim>
    bool
    is_convex(const Point<dim> &x, const FacePatch<dim> &face, const double least_stretch)
    {
      const double farthest = x.distance(face.center()) + face.diameter();
      // From the middle, tangents change by at most the bound of the second derivatives times the
      // distance of the farthest corner: half of the diagonal of a square, sqrt(5)/3 of a triangle.
      const double reach   = is_triangle(face.reference_cell()) ? 0.75 : 0.71;
      const double stretch = least_stretch - reach * face.second_derivative_bound();
      return stretch > 0 && farthest * face.second_derivative_bound() < stretch * stretch;
    }

    /// The projection at a parameter, with its distance and the part of it along the face.
    template <int dim>
    Projection<dim>
    result_at(const Point<dim> &x, const FacePatch<dim> &face, const Point<dim - 1> &xi)
    {
      Projection<dim> result;
      result.xi                   = xi;
      result.position             = face.position(xi);
      const Tensor<1, dim> offset = x - result.position;
      const Tensor<1, dim> normal = face.normal(xi);
      result.distance             = offset.norm();
      result.tangential_offset    = (offset - (offset * normal) * normal).norm();
      result.converged_by_newton  = true;
      return result;
    }
  } // namespace



  // The closest point of a face (doc/theory, (1.8)): Newton's method from the middle if the
  // distance is convex, else from all local minima of a grid of samples, of which the closest
  // result counts. If that start has not converged, values alone are compared, on grids that shrink
  // to 1e-13 of the parameter range. Cost: one sample costs an evaluation of the face.
  template <int dim>
  Projection<dim>
  project(const Point<dim> &x, const FacePatch<dim> &face)
  {
    const double stretch = least_stretch(face);
    if (Point<dim - 1> xi = face.middle();
        is_convex(x, face, stretch) && descend_to_minimum(x, face, xi))
      return result_at(x, face, xi);

    const Samples<dim> samples(x, face, stretch);
    Point<dim - 1>     best;
    double             best_value = std::numeric_limits<double>::max();
    bool               converged  = false;
    for (unsigned int n = 0; n < samples.size(); ++n)
      if (samples.is_local_minimum(n))
        {
          Point<dim - 1> xi    = samples.parameter(n);
          const bool     found = descend_to_minimum(x, face, xi);
          const double   value = x.distance_square(face.position(xi));
          if (value < best_value)
            {
              best       = xi;
              best_value = value;
              converged  = found;
            }
        }
    if (!converged)
      {
        grid_search(x, face, samples.spacing(), best);
        polish(x, face, best);
      }

    Projection<dim> result     = result_at(x, face, best);
    result.converged_by_newton = converged;
    return result;
  }



  template Projection<2>
  project<2>(const Point<2> &, const FacePatch<2> &);
  template Projection<3>
  project<3>(const Point<3> &, const FacePatch<3> &);
} // namespace Signorini
