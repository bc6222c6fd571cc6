// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Signorini
{
  /// A smooth surface near a place: a polynomial height over a plane.
  template <int dim>
  class LocalSurface
  {
  public:
    dealii::Tensor<1, dim> normal;           ///< at the place, of unit length
    double                 offset    = 0;    ///< of the surface from the place, along the normal
    double                 deviation = 0;    ///< root mean square of the points from the surface
    bool                   fits      = true; ///< there are enough points to tell

    LocalSurface() = default;

    /// By least squares, near points counting more. Of third degree, or of second where there are
    /// few points.
    /// @param arms points, from the place
    /// @param up a unit vector about normal to the surface
    /// @param through the place itself
    LocalSurface(const std::vector<dealii::Tensor<1, dim>> &arms,
                 const dealii::Tensor<1, dim>              &up,
                 bool                                       through);

    static LocalSurface
    plane(const dealii::Tensor<1, dim> &normal);

    /// About that of a point.
    /// @param arm from the place to the point
    double
    distance(const dealii::Tensor<1, dim> &arm) const;

    /// Points, so that the deviation says something: more than coefficients.
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
