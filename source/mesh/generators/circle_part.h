// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace Signorini
{
  /// A part of a disc or a ring between two angles, in multiples of right angles from the x axis.
  struct CirclePart
  {
    unsigned int first = 0, quarters = 4;

    /// @return whether the part is cut at the x (or the y) of the centre.
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

    /// @return whether the part is above the centre.
    bool
    is_upper() const
    {
      return quarters < 4 && first + quarters <= 2;
    }
  };

  /// @return the names of all parts: "full", halves and quarters.
  std::vector<std::string>
  circle_part_names();

  /// @return the part of a name.
  /// @param name one of circle_part_names()
  CirclePart
  circle_part(const std::string &name);
} // namespace Signorini
