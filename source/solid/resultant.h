// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Signorini
{
  /// The resultant of the forces on some nodes.
  template <int dim>
  struct Resultant
  {
    dealii::Tensor<1, dim> force;
    dealii::Tensor<1, 3>   moment; ///< about the origin; 2D: the first component alone

    Resultant &
    operator+=(const Resultant &other)
    {
      force += other.force;
      moment += other.moment;
      return *this;
    }
  };

  /// The moment x x f; in 2D its only component is the first one.
  template <int dim>
  dealii::Tensor<1, 3>
  moment_of(const dealii::Point<dim> &x, const dealii::Tensor<1, dim> &f)
  {
    dealii::Tensor<1, 3> m;
    if constexpr (dim == 2)
      m[0] = x[0] * f[1] - x[1] * f[0];
    else
      m = dealii::cross_product_3d(x, f);
    return m;
  }

  /// The resultant of a single force f at x.
  template <int dim>
  Resultant<dim>
  resultant_of(const dealii::Point<dim> &x, const dealii::Tensor<1, dim> &f)
  {
    return {f, moment_of(x, f)};
  }
} // namespace Signorini
