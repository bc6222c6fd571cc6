// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/generators/named_surface.h"

namespace Signorini
{
  /// Where a copy of a mesh in the first quadrant or octant about the origin goes.
  struct CopyRotation
  {
    unsigned int quarters;            ///< quarter turns about the origin (3D: the z axis)
    bool         upside_down = false; ///< 3D: after that, half a turn about the x axis
  };

  /// Copies of a mesh, turned without rounding, and joined where they touch. Lengths are of order
  /// one.
  template <int dim>
  void
  merge_copies(const dealii::Triangulation<dim> &first,
               const std::vector<CopyRotation>  &turns,
               dealii::Triangulation<dim>       &whole);

  /// The parts of balls and spherical shells that can be meshed.
  const std::vector<std::string> ball_parts{"full", "lower half", "lower quarter"};

  /// For the `help` of a choice among them.
  const std::string ball_part_help =
    "of the whole; the lower half is z <= cz, cut at `top`; of that, the lower quarter is the "
    "piece x >= cx, y >= cy, cut at `symmetry_x` and `symmetry_y` too";

  std::vector<CopyRotation>
  turns_of_ball_part(const std::string &part);

  /// The plane boundaries of a part.
  std::vector<NamedSurface<3>>
  cuts_of_ball_part(const std::string &part, const dealii::Point<3> &center, double radius);
} // namespace Signorini
