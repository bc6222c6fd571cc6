// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/grid/manifold.h>

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
} // namespace Signorini
