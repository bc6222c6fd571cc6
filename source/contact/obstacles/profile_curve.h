// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Signorini
{
  /// A curve in the plane, of straight lines and circular arcs one after the other. Outside is on
  /// the left of the way along it.
  class ProfileCurve
  {
  public:
    /// The closest point of the curve, seen from a point.
    struct Foot
    {
      double               gap;           ///< distance [length], positive outside
      dealii::Tensor<1, 2> normal;        ///< unit, to the outside
      double               curvature = 0; ///< of the parallel curve through the point; 0 at corners
    };

    /// Throws SceneError for a text that is not understood, for an end of an arc that is not on its
    /// circle, and for arcs of 180 degrees or more.
    /// @param text the start "x, y", then the ends of lines "x, y" and of arcs "x, y, cx, cy" with
    /// their centre, separated by ';'
    /// @param is_reversed the other side is outside
    explicit ProfileCurve(const std::string &text, bool is_reversed = false);

    /// Empty curves have none.
    bool
    empty() const
    {
      return segments.empty();
    }

    /// The closest point; the curve is not empty. At corners the sign is that of the mean of both
    /// normals.
    Foot
    closest(const dealii::Point<2> &x) const;

  private:
    struct Segment
    {
      dealii::Point<2> begin, end, centre;
      /// 1 for arcs that go around their centre anticlockwise, -1 for others, 0 for lines.
      double turn = 0;

      /// The unit normal to the left at a point of the segment.
      dealii::Tensor<1, 2>
      normal(const dealii::Point<2> &at) const;
      /// The closest point.
      dealii::Point<2>
      foot(const dealii::Point<2> &x) const;
    };

    std::vector<Segment> segments;
  };
} // namespace Signorini
