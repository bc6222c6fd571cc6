// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/mesh/generator.h>

#include <functional>

namespace Signorini
{
  /// A boundary of a generated mesh: all boundary faces whose vertices it contains.
  template <int dim>
  struct NamedSurface
  {
    std::string name;
    /// Whether a point is on the surface, up to rounding.
    std::function<bool(const dealii::Point<dim> &)> contains;
    /// The manifold of its faces and their edges; null: they keep the manifold that they have.
    std::shared_ptr<dealii::Manifold<dim>> manifold;
  };

  /// Throws SceneError if a size cannot be resolved in double precision, or not at its distance
  /// from the origin.
  /// @param section of the key
  /// @param key that has the size
  /// @param size [length]
  /// @param reach largest distance [length] from the origin
  void
  check_size(const Section &section, const std::string &key, double size, double reach);

  /// @return the plane on which a coordinate has a value.
  /// @param name of the boundary
  /// @param axis number of the coordinate
  /// @param value of the coordinate
  /// @param size of the mesh, to which the tolerance is relative
  template <int dim>
  NamedSurface<dim>
  plane(const std::string &name, unsigned int axis, double value, double size);

  /// @return a sphere (2D: circle), without manifold.
  /// @param name of the boundary
  /// @param center of the sphere
  /// @param radius of the sphere
  template <int dim>
  NamedSurface<dim>
  sphere(const std::string &name, const dealii::Point<dim> &center, double radius);

  /// @return the names of some surfaces.
  template <int dim>
  std::vector<std::string>
  names_of(const std::vector<NamedSurface<dim>> &surfaces);

  /// Assign each boundary face to the first surface that contains it, which sets its manifold.
  /// @param triangulation the mesh, whose generator may use the manifold id 0, and no other, on
  /// cells
  /// @param surfaces which contain all boundary faces
  /// @return the coarse mesh
  template <int dim>
  CoarseMesh<dim>
  with_boundaries(dealii::Triangulation<dim>           &triangulation,
                  const std::vector<NamedSurface<dim>> &surfaces);
} // namespace Signorini
