// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// A smooth surface near a point, the origin: a polynomial height over a plane, fitted to points
  /// around.
  template <int dim>
  class LocalSurface
  {
  public:
    /// Unit normal of the surface at the origin.
    dealii::Tensor<1, dim> normal;
    /// Signed distance [length] of the surface from the origin along the normal; 0 if it passes
    /// through the origin.
    double offset = 0;
    /// Root mean square of the distances [length] of the points from the surface.
    double deviation = 0;
    /// Whether there were enough points to determine the surface.
    bool fits = true;

    LocalSurface() = default;

    /// Fit by weighted least squares, in which near points have more weight. The polynomial is of
    /// third degree, or of second where there are few points.
    /// @param arms the points, as vectors from the origin
    /// @param up a unit vector that is about normal to the surface
    /// @param through whether the surface passes through the origin exactly
    LocalSurface(const std::vector<dealii::Tensor<1, dim>> &arms,
                 const dealii::Tensor<1, dim>              &up,
                 bool                                       through);

    /// @return the plane through the origin with this normal.
    /// @param normal a unit vector
    static LocalSurface
    plane(const dealii::Tensor<1, dim> &normal);

    /// @return the distance [length] of a point from the surface, measured along `up`, which is
    /// about normal to it.
    /// @param arm the point, as a vector from the origin
    double
    distance(const dealii::Tensor<1, dim> &arm) const;

    /// A number of points that exceeds the number of coefficients of the cubic polynomial
    /// sufficiently for the deviation to be an estimate of the error.
    static constexpr unsigned int enough = dim == 2 ? 4 : 18;

  private:
    std::array<double, dim - 1>
    place_of(const dealii::Tensor<1, dim> &arm) const;

    dealii::Tensor<1, dim>                      up;
    std::array<dealii::Tensor<1, dim>, dim - 1> axes; ///< of the plane, by the extent of the points
    unsigned int                                degree = 0;
    std::vector<double> coefficients; ///< of height by powers along the axes
  };
} // namespace Signorini
