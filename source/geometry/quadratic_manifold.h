// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <vector>

namespace Signorini
{
  /// The isoparametric map of a cell of second order from the unit cell, and its inverse by
  /// Newton's method.
  template <int dim>
  class QuadraticMap
  {
  public:
    /// @param nodes positions of the cell's nodes, in the order of MeshFile::Element. Nodes that a
    /// cell of 8 (2D) or 20 (3D) lacks in the middle lie where the serendipity functions of such a
    /// cell put them.
    explicit QuadraticMap(const std::vector<dealii::Point<dim>> &nodes);

    dealii::Point<dim>
    value(const dealii::Point<dim> &xi) const;

    /// dx/dxi
    dealii::Tensor<2, dim>
    gradient(const dealii::Point<dim> &xi) const;

    /// Throws std::runtime_error if there is no xi in or near the unit cell.
    dealii::Point<dim>
    inverse(const dealii::Point<dim> &x) const;

    /// Are all nodes where the corners alone would put them?
    bool
    is_multilinear() const;

    /// Is the determinant of the gradient of one sign, at all nodes and in between?
    bool
    is_invertible() const;

  private:
    std::vector<dealii::Point<dim>> points; ///< 3^dim, the first coordinate runs fastest
    double                          size;   ///< largest distance from the first corner
  };

  /// The inside, the faces and the lines of a curved cell.
  template <int dim>
  class QuadraticManifold : public dealii::ChartManifold<dim, dim, dim>
  {
  public:
    explicit QuadraticManifold(const QuadraticMap<dim> &map)
      : map(map)
    {}

    std::unique_ptr<dealii::Manifold<dim>>
    clone() const override
    {
      return std::make_unique<QuadraticManifold<dim>>(map);
    }

    dealii::Point<dim>
    pull_back(const dealii::Point<dim> &x) const override
    {
      return map.inverse(x);
    }

    dealii::Point<dim>
    push_forward(const dealii::Point<dim> &xi) const override
    {
      return map.value(xi);
    }

    dealii::DerivativeForm<1, dim, dim>
    push_forward_gradient(const dealii::Point<dim> &xi) const override
    {
      return dealii::DerivativeForm<1, dim, dim>(map.gradient(xi));
    }

  private:
    const QuadraticMap<dim> map;
  };
} // namespace Signorini
