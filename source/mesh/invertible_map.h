// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/expression.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /// A map x = F(X) given by formulas, with its inverse by damped Newton iterations.
  template <int dim>
  class InvertibleMap
  {
  public:
    /// Throws SceneError if F does not prescribe all components, or is not finite at the points.
    /// @param F the formulas
    /// @param points distributed over the region where the map is used: the inverse starts from the
    /// one whose image is closest, which also selects one of several solutions
    InvertibleMap(const VectorExpression<dim> &F, const std::vector<dealii::Point<dim>> &points);

    /// @return F(X).
    /// @param X a point before the map
    dealii::Point<dim>
    value(const dealii::Point<dim> &X) const;

    /// @return whether F is affine, up to rounding, at the points and at others between them, so
    /// that straight lines remain straight.
    bool
    is_affine() const;

    /// @return dF/dX by central differences.
    /// @param X a point before the map
    dealii::Tensor<2, dim>
    gradient(const dealii::Point<dim> &X) const;

    /// @return X with F(X) = x. Throws std::runtime_error if there is none near the points.
    /// @param x a point after the map
    dealii::Point<dim>
    inverse(const dealii::Point<dim> &x) const;

  private:
    /// A point with its image.
    struct Pair
    {
      dealii::Point<dim> image, X;
    };

    /// @return the pair whose image is closest to x.
    const Pair &
    nearest(const dealii::Point<dim> &x) const;

    /// @return the solution of F(X) = x by Newton's method from a start; none if it fails.
    std::optional<dealii::Point<dim>>
    solve(const dealii::Point<dim> &x, dealii::Point<dim> start) const;

    VectorExpression<dim> F;
    /// Mean of the points.
    dealii::Point<dim> middle;
    /// Sorted by the first coordinate of the image.
    std::vector<Pair> pairs;
    double            X_size = 0, x_size = 0;
  };
} // namespace Signorini
