// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /// A map x = F(X) given by formulas, and its inverse by Newton's method.
  template <int dim>
  class InvertibleMap
  {
  public:
    /// `points` are spread over the region where the map is used: the inverse starts from that one
    /// whose image is closest, which also settles which of several solutions is meant. Throws
    /// SceneError if F leaves components free or is not finite there.
    InvertibleMap(const VectorExpression<dim> &F, const std::vector<dealii::Point<dim>> &points);

    dealii::Point<dim>
    value(const dealii::Point<dim> &X) const;

    /// True if F keeps straight what is straight: at the points, and at others between them, it is
    /// a linear map and a shift, up to rounding.
    bool
    is_affine() const;

    /// dF/dX, by central differences.
    dealii::Tensor<2, dim>
    gradient(const dealii::Point<dim> &X) const;

    /// Throws std::runtime_error if there is no X near the points.
    dealii::Point<dim>
    inverse(const dealii::Point<dim> &x) const;

  private:
    struct Pair
    {
      dealii::Point<dim> image, X;
    };

    const Pair &
    nearest(const dealii::Point<dim> &x) const;

    /// From there by Newton's method; nothing if it fails.
    std::optional<dealii::Point<dim>>
    solve(const dealii::Point<dim> &x, dealii::Point<dim> start) const;

    VectorExpression<dim> F;
    dealii::Point<dim>    middle; ///< of the points
    std::vector<Pair>     pairs;  ///< in the order of the first coordinate of the image
    double                X_size = 0, x_size = 0;
  };
} // namespace Signorini
