// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// A part of a disc or a ring: that between two angles, in right angles from the x axis.
  struct CirclePart
  {
    unsigned int first = 0, quarters = 4;

    /// Cut along the line of all points with the x, or the y, of the center.
    bool
    is_cut_at_x() const
    {
      return quarters == 1 || (quarters == 2 && first % 2 == 1);
    }

    bool
    is_cut_at_y() const
    {
      return quarters == 1 || (quarters == 2 && first % 2 == 0);
    }

    /// True if it lies above the center.
    bool
    is_upper() const
    {
      return quarters < 4 && first + quarters <= 2;
    }
  };

  /// For the choice among them: "full", halves and quarters.
  std::vector<std::string>
  circle_part_names();

  /// `name` is one of circle_part_names().
  CirclePart
  circle_part(const std::string &name);
} // namespace Signorini
