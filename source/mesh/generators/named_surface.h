// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/mesh/generator.h>

#include <functional>

namespace Signorini
{
  /// A boundary of a generated mesh: the boundary faces all of whose vertices it contains.
  template <int dim>
  struct NamedSurface
  {
    std::string                                     name;
    std::function<bool(const dealii::Point<dim> &)> contains;
    /// Where new points of its faces and their edges go; null: the faces keep the manifold they
    /// have.
    std::shared_ptr<dealii::Manifold<dim>> manifold;
  };

  /// Refuse a size, given by a key, that numbers cannot tell from nothing, or at that distance from
  /// the origin.
  void
  check_size(const Section &section, const std::string &key, double size, double reach);

  /// The plane on which coordinate number `axis` has the given value. `size` is that of the mesh:
  /// the tolerance is relative to it.
  template <int dim>
  NamedSurface<dim>
  plane(const std::string &name, unsigned int axis, double value, double size);

  /// The sphere (2D: circle), without a manifold.
  template <int dim>
  NamedSurface<dim>
  sphere(const std::string &name, const dealii::Point<dim> &center, double radius);

  template <int dim>
  std::vector<std::string>
  names_of(const std::vector<NamedSurface<dim>> &surfaces);

  /// Name the boundary faces after the first surface that contains them, which sets their manifold.
  /// The generator itself may use the manifold id 0, and no other, on cells.
  template <int dim>
  CoarseMesh<dim>
  with_boundaries(dealii::Triangulation<dim>           &triangulation,
                  const std::vector<NamedSurface<dim>> &surfaces);
} // namespace Signorini
