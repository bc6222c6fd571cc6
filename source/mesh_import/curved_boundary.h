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
  /// A boundary of a mesh file that lies on a sphere (2D: circle) or a cylinder about a given
  /// centre or axis. The radius is the mean distance of its vertices.
  template <int dim>
  struct CurvedBoundary
  {
    /// Name of the boundary.
    std::string name;
    /// Centre of the sphere, or any point of the axis of the cylinder.
    dealii::Point<dim> center;
    /// Unit vector along the axis of the cylinder; zero for a sphere.
    dealii::Tensor<1, dim> axis;

    /// @return the deal.II manifold of the surface, which needs no radius.
    std::unique_ptr<dealii::Manifold<dim>>
    manifold() const;

    /// @return the vector to a point from the centre of the sphere, or from the closest point of
    /// the axis.
    /// @param p the point
    dealii::Tensor<1, dim>
    arm(const dealii::Point<dim> &p) const;

    /// Move the vertices of faces with certain boundary ids onto the surface, and give the faces
    /// and their lines a manifold id. Throws SceneError if vertices deviate from the mean radius by
    /// more than 1e-3 of it.
    /// @param triangulation a coarse mesh, which is changed
    /// @param boundary the boundary ids
    /// @param manifold the id that the manifold gets
    /// @param inserted for each vertex whether it was inserted by dividing cells; such vertices may
    /// be off the surface
    void
    apply(dealii::Triangulation<dim>                 &triangulation,
          const std::set<dealii::types::boundary_id> &boundary,
          dealii::types::manifold_id                  manifold,
          const std::vector<bool>                    &inserted) const;
  };

  /// Read curved boundaries from a scene.
  /// @param text items `NAME sphere cx cy cz` (2D: `NAME circle cx cy`) or `NAME cylinder px py pz
  /// ax ay az` with a point and the direction of the axis, separated by `;`
  /// @return one entry for each item
  /// @throws SceneError if an item has another form
  template <int dim>
  std::vector<CurvedBoundary<dim>>
  curved_boundaries_from(const std::string &text);
} // namespace Signorini
