// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/dense.h"
#include "mesh_import/reconstruction/curved_faces.h"

#include <array>
#include <cmath>


namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::MatrixXd;

    template <int dim>
    Eigen::Matrix<double, dim, 1>
    eigen(const Tensor<1, dim> &t)
    {
      Eigen::Matrix<double, dim, 1> result;
      for (unsigned int d = 0; d < dim; ++d)
        result(d) = t[d];
      return result;
    }

    /// @return an orthonormal basis of the plane normal to `up`, along the principal axes of the
    /// projected points, with the direction of the largest extent last.
    template <int dim>
    Eigen::Matrix<double, dim, dim - 1>
    plane_of(const std::vector<Tensor<1, dim>> &arms, const Tensor<1, dim> &up)
    {
      const auto n  = eigen(up);
      using Square  = Eigen::Matrix<double, dim, dim>;
      Square spread = Square::Zero();
      for (const auto &arm : arms)
        {
          const auto flat = (eigen(arm) - (arm * up) * n).eval();
          spread += flat * flat.transpose();
        }
      // A large negative multiple of n n^T makes the normal the eigenvector of the smallest
      // eigenvalue, so that the others span the plane.
      spread -= spread.trace() * n * n.transpose();
      return eigenpairs_of_symmetric(spread).vectors.rightCols(dim - 1);
    }

    /// @return all monomials of x up to a total degree, in the order of their degrees.
    template <int dim>
    std::vector<double>
    powers(const std::array<double, dim - 1> &x, const unsigned int degree)
    {
      std::vector<double> result;
      for (unsigned int n = 0; n <= degree; ++n)
        for (unsigned int j = 0; j <= (dim == 2 ? 0 : n); ++j)
          result.push_back(std::pow(x[0], n - j) * std::pow(x[dim - 2], j));
      return result;
    }

    /// @return the number of monomials of total degree up to `degree` in dim-1 variables.
    constexpr int
    n_powers(const int dim, const int degree)
    {
      return dim == 2 ? degree + 1 : (degree + 1) * (degree + 2) / 2;
    }
  } // namespace



  // Weighted and regularised linear least squares for the coefficients of the height over the plane
  // normal to `up`. Cubic polynomials are used if there are `spare` points more than coefficients,
  // otherwise quadratic ones; `fits` is false if there are too few points for these. The surface
  // passes through the origin if the coefficient of degree 0 is left out.
  template <int dim>
  LocalSurface<dim>::LocalSurface(const std::vector<Tensor<1, dim>> &arms,
                                  const Tensor<1, dim>              &up,
                                  const bool                         through)
    : normal(up)
    , up(up)
  {
    constexpr int spare = dim == 2 ? 1 : 2; // points
    const int     rows  = arms.size();
    degree              = rows - spare < n_powers(dim, 3) - through ? 2 : 3;
    const int n         = n_powers(dim, degree);
    fits                = rows - spare >= n - through;
    if (!fits)
      return;

    // Coordinates along the plane are scaled by the extent of the points, so that all monomials are
    // of order one.
    const auto plane = plane_of(arms, up);
    for (unsigned int e = 0; e < dim - 1; ++e)
      {
        double extent = 0;
        for (const auto &arm : arms)
          extent = std::max(extent, std::abs(eigen(arm).dot(plane.col(e))));
        for (unsigned int d = 0; d < dim; ++d)
          axes[e][d] = plane(d, e) / extent;
      }

    // Coefficients that the points do not determine (for example those of second degree across two
    // rows of points) are set to zero by a small Tikhonov term, which prefers terms of lower
    // degree.
    constexpr std::array<double, 4> damping{{0, 0, 1e-5, 1e-4}};
    Matrix                          A = Matrix::Zero(rows + n, n);
    Vector                          b = Vector::Zero(rows + n);
    for (int i = 0; i < rows; ++i)
      {
        const auto place  = place_of(arms[i]);
        const auto values = powers<dim>(place, degree);
        // Near points have more weight, by the inverse of their (scaled) distance.
        const double weight = 1 / (0.1 + std::hypot(place[0], dim == 2 ? 0. : place[dim - 2]));
        for (int j = 0; j < n; ++j)
          A(i, j) = weight * values[j];
        b(i) = weight * (arms[i] * up);
      }
    for (int j = 0, order = 0; j < n; ++j)
      {
        if (j >= n_powers(dim, order))
          ++order;
        A(rows + j, j) = damping[order];
      }
    Vector x = Vector::Zero(n);
    if (through)
      x.tail(n - 1) = solve_least_squares(A.rightCols(n - 1), b);
    else
      x = solve_least_squares(A, b);
    coefficients.assign(x.data(), x.data() + n);

    // The root mean square of the deviations, with the number of spare points for unbiased scale.
    for (const auto &arm : arms)
      deviation += std::pow(distance(arm), 2) / (rows - (n - through));
    deviation = std::sqrt(deviation);
    for (unsigned int e = 0; e < dim - 1; ++e)
      normal -= coefficients[1 + e] * axes[e];
    const double length = normal.norm();
    normal /= length;
    // The distance of the tangent plane at the origin. For offsets of the size of a sagitta that is
    // the distance of the surface.
    offset = coefficients[0] / length;
    fits   = std::isfinite(length) && std::isfinite(deviation);
  }



  template <int dim>
  std::array<double, dim - 1>
  LocalSurface<dim>::place_of(const Tensor<1, dim> &arm) const
  {
    std::array<double, dim - 1> result;
    for (unsigned int e = 0; e < dim - 1; ++e)
      result[e] = arm * axes[e];
    return result;
  }



  template <int dim>
  double
  LocalSurface<dim>::distance(const Tensor<1, dim> &arm) const
  {
    const auto values = powers<dim>(place_of(arm), degree);
    double     result = arm * up;
    for (unsigned int j = 0; j < coefficients.size(); ++j)
      result -= coefficients[j] * values[j];
    return std::abs(result);
  }



  template <int dim>
  LocalSurface<dim>
  LocalSurface<dim>::plane(const Tensor<1, dim> &normal)
  {
    LocalSurface<dim> result;
    result.normal = result.up = normal;
    return result;
  }



  template class LocalSurface<2>;
  template class LocalSurface<3>;
} // namespace Signorini
