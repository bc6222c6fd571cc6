// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /// A boundary of a mesh file that lies on a sphere (2D: circle) or a cylinder. The radius is that
  /// of its vertices.
  template <int dim>
  struct CurvedBoundary
  {
    std::string            name;
    dealii::Point<dim>     center; ///< of the sphere, or any point of the cylinder's axis
    dealii::Tensor<1, dim> axis;   ///< unit vector; zero for a sphere

    std::unique_ptr<dealii::Manifold<dim>>
    manifold() const;

    /// From the center or the axis to p.
    dealii::Tensor<1, dim>
    arm(const dealii::Point<dim> &p) const;

    /// Move the vertices of faces with this boundary id onto the surface, and give the faces this
    /// manifold id. Throws SceneError if vertices are off by more than 1e-3 of the radius.
    /// @param inserted vertices between others, which may be off: those of divided cells
    void
    apply(dealii::Triangulation<dim>                 &triangulation,
          const std::set<dealii::types::boundary_id> &boundary,
          dealii::types::manifold_id                  manifold,
          const std::vector<bool>                    &inserted) const;
  };

  /// Items `NAME sphere cx cy cz` (2D: `NAME circle cx cy`) or `NAME cylinder px py pz ax ay az`
  /// with a point and the direction of the axis, separated by `;`. Throws SceneError.
  template <int dim>
  std::vector<CurvedBoundary<dim>>
  curved_boundaries_from(const std::string &text);
} // namespace Signorini
