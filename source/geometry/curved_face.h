// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <array>

namespace Signorini
{
  /// A cubic (Hermite) curve between two points with given directions there. The lengths of the
  /// tangents are chosen such that an arc of a circle of angle t is approximated with an error of
  /// order t^6.
  template <int dim>
  class CubicCurve
  {
  public:
    /// A straight line.
    /// @param from,to its ends
    CubicCurve(const dealii::Point<dim> &from, const dealii::Point<dim> &to);

    /// A curve.
    /// @param from,to its ends
    /// @param start,end unit tangents, both in the direction of the curve
    CubicCurve(const dealii::Point<dim>     &from,
               const dealii::Point<dim>     &to,
               const dealii::Tensor<1, dim> &start,
               const dealii::Tensor<1, dim> &end);

    /// @return the point at a parameter.
    /// @param t from 0 to 1
    dealii::Point<dim>
    value(double t) const;

    /// @return the derivative by the parameter.
    /// @param t from 0 to 1
    dealii::Tensor<1, dim>
    derivative(double t) const;

  private:
    dealii::Point<dim>     from, to;
    dealii::Tensor<1, dim> start, end;
  };

  /// A curved face as manifold: in 2D a curve; in 3D the Coons patch between four curves.
  template <int dim>
  class CurvedFace : public dealii::ChartManifold<dim, dim, dim - 1>
  {
  public:
    /// The edges; in 3D in deal.II's order of the lines of a quadrilateral: x = 0, x = 1 (along y),
    /// y = 0, y = 1 (along x).
    using Edges = std::array<CubicCurve<dim>, dim == 2 ? 1 : 4>;

    explicit CurvedFace(const Edges &edges)
      : edges(edges)
    {}

    std::unique_ptr<dealii::Manifold<dim>>
    clone() const override
    {
      return std::make_unique<CurvedFace<dim>>(edges);
    }

    /// @return the parameter of the closest point of the face.
    dealii::Point<dim - 1>
    pull_back(const dealii::Point<dim> &x) const override;

    dealii::Point<dim>
    push_forward(const dealii::Point<dim - 1> &xi) const override;

    dealii::DerivativeForm<1, dim - 1, dim>
    push_forward_gradient(const dealii::Point<dim - 1> &xi) const override;

  private:
    const Edges edges;
  };
} // namespace Signorini
