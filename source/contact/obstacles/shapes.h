// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/contact/obstacles/obstacle.h>

namespace Signorini
{
  /// The names of all obstacle shapes.
  template <int dim>
  std::vector<std::string>
  obstacle_names();

  /// `name` is one of obstacle_names<dim>().
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_shape(const std::string &name);

  // Each shape is a class in a file of its own; only the functions that make them are declared
  // here.

  /// Half space behind a point, with its outward normal.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_plane();

  /// Sphere (2D: circular cylinder), pressed from outside, or a spherical seat.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_sphere();

  /// Circular cylinder about an axis; in 2D the axis is z.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_cylinder();

  /// Paraboloid of revolution (2D: parabola) with a radius of curvature at the apex; the gap is
  /// measured along the axis, as in Hertz' theory.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_paraboloid();

  /// Flat circular face (2D: strip) with rounded edges, at the end of a shaft.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_punch();

  /// Circular cone (2D: wedge).
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_cone();

  /// Lines and arcs in a plane; in space moved along a line, or turned about an axis.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_profile();

  /// Any surface, given by the gap along a fixed normal.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_gap_function();

  /// Surface of triangles in an STL file; the gap is the signed distance. 3D only.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_stl();

  /// The surface of the slave itself, for rigid couplings and foundations.
  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_attached();
} // namespace Signorini
