// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/invertible_map.h"
#include <signorini/geometry/coarse_mesh.h>

namespace Signorini
{
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
