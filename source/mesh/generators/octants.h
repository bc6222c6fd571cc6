// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/named_surface.h"

namespace Signorini
{
  /// The rotation of a copy of a mesh in the first quadrant or octant around the origin.
  struct CopyRotation
  {
    /// Number of rotations by 90 degrees about the origin (3D: the z axis).
    unsigned int quarters;
    /// 3D: whether a rotation by 180 degrees about the x axis follows.
    bool upside_down = false;
  };

  /// Merge rotated copies of a mesh where they touch. Rotations have no rounding.
  /// @param first the mesh in the first quadrant or octant, with lengths of order one
  /// @param turns rotations of the copies
  /// @param whole receives the merged mesh, without manifolds
  template <int dim>
  void
  merge_copies(const dealii::Triangulation<dim> &first,
               const std::vector<CopyRotation>  &turns,
               dealii::Triangulation<dim>       &whole);

  /// The parts of balls and spherical shells that can be meshed.
  const std::vector<std::string> ball_parts{"full", "lower half", "lower quarter"};

  /// Help text of the choice of a part.
  const std::string ball_part_help =
    "of the whole; the lower half is z <= cz, cut at `top`; of that, the lower quarter is the "
    "piece x >= cx, y >= cy, cut at `symmetry_x` and `symmetry_y` too";

  /// @return the rotations of the octants of which a part of a ball consists.
  std::vector<CopyRotation>
  turns_of_ball_part(const std::string &part);

  /// @return the plane boundaries of a part of a ball.
  std::vector<NamedSurface<3>>
  cuts_of_ball_part(const std::string &part, const dealii::Point<3> &center, double radius);
} // namespace Signorini
