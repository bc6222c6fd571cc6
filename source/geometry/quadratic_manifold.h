// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <vector>

namespace Signorini
{
  /// The isoparametric map of a cell of second order from the reference cell, with its inverse.
  template <int dim>
  class QuadraticMap
  {
  public:
    /// @param nodes positions of the nodes, in the order of MeshFile::Element. Nodes in the middle
    /// of faces and cell that a cell of 8 (2D) or 20 (3D) nodes lacks are placed by the serendipity
    /// functions of such a cell.
    explicit QuadraticMap(const std::vector<dealii::Point<dim>> &nodes);

    /// @return the position of a point of the reference cell.
    /// @param xi reference coordinates
    dealii::Point<dim>
    value(const dealii::Point<dim> &xi) const;

    /// @return the gradient dx/dxi.
    /// @param xi reference coordinates
    dealii::Tensor<2, dim>
    gradient(const dealii::Point<dim> &xi) const;

    /// @return the reference coordinates of a point. Throws std::runtime_error if there are none in
    /// or near the reference cell.
    /// @param x a point in or near the cell
    dealii::Point<dim>
    inverse(const dealii::Point<dim> &x) const;

    /// @return whether all nodes are where the corners alone would place them, up to 1e-8 of the
    /// size.
    bool
    is_multilinear() const;

    /// @return whether the determinant of the gradient has one sign at all nodes and points between
    /// them.
    bool
    is_invertible() const;

  private:
    /// The 3^dim nodes, the first coordinate running fastest.
    std::vector<dealii::Point<dim>> points;
    /// Largest distance [length] of a node from the first corner.
    double size;
  };

  /// The manifold of the interior, the faces and the lines of a curved cell.
  template <int dim>
  class QuadraticManifold : public dealii::ChartManifold<dim, dim, dim>
  {
  public:
    /// @param map of the cell, which is copied
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
