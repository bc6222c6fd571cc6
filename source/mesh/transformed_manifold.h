// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/geometry/coarse_mesh.h>
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

  /// The image of a manifold under a map: new points are computed on the original manifold and
  /// mapped.
  template <int dim>
  class TransformedManifold : public dealii::Manifold<dim>
  {
  public:
    using Points = dealii::ArrayView<const dealii::Point<dim>>;

    /// @param map the transformation
    /// @param base the original manifold; null: flat space
    TransformedManifold(std::shared_ptr<const InvertibleMap<dim>>    map,
                        std::shared_ptr<const dealii::Manifold<dim>> base = nullptr);

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

    dealii::Point<dim>
    project_to_manifold(const Points             &surrounding,
                        const dealii::Point<dim> &candidate) const override;

    dealii::Tensor<1, dim>
    get_tangent_vector(const dealii::Point<dim> &x1, const dealii::Point<dim> &x2) const override;

  private:
    /// @return the points before the map.
    std::vector<dealii::Point<dim>>
    before_map(const Points &points) const;

    std::shared_ptr<const InvertibleMap<dim>>    map;
    std::shared_ptr<const dealii::Manifold<dim>> base;
  };

  /// Transform a mesh by x = F(X). Afterwards every cell, face and line has a manifold, the
  /// transformed former one, so that refined points are exactly on the image; a mesh that stays
  /// straight needs none. Throws SceneError if F does not prescribe all components, is not finite,
  /// or inverts cells.
  /// @param mesh which is changed
  /// @param is_curved whether it has been curved before
  /// @param F the formulas
  /// @return whether the mesh is curved
  template <int dim>
  bool
  transform(CoarseMesh<dim> &mesh, bool is_curved, const VectorExpression<dim> &F);
} // namespace Signorini
