// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>
#include <vector>

namespace Signorini
{
  /// Circles or spheres around a centre, or cylinders around an axis. The manifolds of deal.II
  /// treat points closer than 1e-10 as equal, whatever the unit of length; here they are called
  /// with coordinates relative to the centre, in units of about the distance from it.
  template <int dim>
  class RoundManifold : public dealii::Manifold<dim>
  {
  public:
    using Points = dealii::ArrayView<const dealii::Point<dim>>;

    /// @param center of the circles or spheres, or a point of the axis
    /// @param axis a unit vector; zero: around the centre
    explicit RoundManifold(const dealii::Point<dim>     &center,
                           const dealii::Tensor<1, dim> &axis = dealii::Tensor<1, dim>());

    std::unique_ptr<dealii::Manifold<dim>>
    clone() const override;

    dealii::Point<dim>
    get_intermediate_point(const dealii::Point<dim> &p1,
                           const dealii::Point<dim> &p2,
                           double                    w) const override;

    dealii::Point<dim>
    get_new_point(const Points                          &surrounding,
                  const dealii::ArrayView<const double> &weights) const override;

    void
    get_new_points(const Points                         &surrounding,
                   const dealii::Table<2, double>       &weights,
                   dealii::ArrayView<dealii::Point<dim>> new_points) const override;

    dealii::Tensor<1, dim>
    get_tangent_vector(const dealii::Point<dim> &x1, const dealii::Point<dim> &x2) const override;

  private:
    /// Points relative to the centre, divided by a power of two, which changes no digit.
    struct Scaled
    {
      double                          unit;
      std::vector<dealii::Point<dim>> points;
    };

    Scaled
    scaled(const Points &points) const;

    /// @return a scaled point in the original coordinates.
    dealii::Point<dim>
    in_space(const dealii::Point<dim> &point, double unit) const;

    dealii::Point<dim>                           center;
    std::shared_ptr<const dealii::Manifold<dim>> about_origin;
  };

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

  /// @return whether the determinant of the map of a simplex of second order is not positive at a
  /// node or at a point between them.
  /// @param nodes corners and middles of lines, in deal.II's order
  template <int dim>
  bool
  is_inverted_simplex(const std::vector<dealii::Point<dim>> &nodes);

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

  /// The parabola between two points with a third one in its middle, as a manifold of one line.
  template <int dim>
  class ParabolicLine : public dealii::Manifold<dim>
  {
  public:
    /// @param bend from the middle of the straight line to the point in the middle [length]
    explicit ParabolicLine(const dealii::Tensor<1, dim> &bend)
      : bend(bend)
    {}

    std::unique_ptr<dealii::Manifold<dim>>
    clone() const override
    {
      return std::make_unique<ParabolicLine<dim>>(bend);
    }

    dealii::Point<dim>
    get_intermediate_point(const dealii::Point<dim> &p1,
                           const dealii::Point<dim> &p2,
                           const double              w) const override
    {
      return p1 + w * (p2 - p1) + 4 * w * (1 - w) * bend;
    }

    dealii::Tensor<1, dim>
    get_tangent_vector(const dealii::Point<dim> &x1, const dealii::Point<dim> &x2) const override
    {
      return x2 - x1 + 4 * bend;
    }

  private:
    const dealii::Tensor<1, dim> bend;
  };

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
