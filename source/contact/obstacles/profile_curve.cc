// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/profile_curve.h"

#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Points that coincide, relative to lengths of the curve.
    constexpr double rounding = 1e-10;

    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    std::vector<double>
    numbers_of(const std::string &part)
    {
      std::vector<double> result;
      for (const std::string &word : split(part, ','))
        {
          char *end = nullptr;
          result.push_back(std::strtod(word.c_str(), &end));
          if (*end != 0 || !std::isfinite(result.back()))
            throw SceneError("'" + word + "' is no number");
        }
      return result;
    }
  } // namespace



  ProfileCurve::ProfileCurve(const std::string &text, const bool is_reversed)
  {
    Point<2> last;
    bool     is_first = true;
    for (const std::string &part : split(text, ';'))
      {
        const std::vector<double> x = numbers_of(part);
        if (x.size() != 2 && (is_first || x.size() != 4))
          throw SceneError("'" + part +
                           "' is not the end x, y of a line, or x, y, cx, cy of an arc");
        Segment one{last, Point<2>(x[0], x[1]), {}};
        last = one.end;
        if (std::exchange(is_first, false))
          continue;
        if (one.begin.distance(one.end) == 0)
          throw SceneError("'" + part + "' is where its line or arc begins");
        if (x.size() == 4)
          {
            one.centre           = Point<2>(x[2], x[3]);
            const Tensor<1, 2> a = one.begin - one.centre, b = one.end - one.centre;
            const double       side = cross(a, b);
            if (std::abs(a.norm() - b.norm()) > 1e-3 * a.norm())
              throw SceneError("'" + part + "': begin and end of the arc are " +
                               short_text(a.norm(), 6) + " and " + short_text(b.norm(), 6) +
                               " from its centre");
            if (std::abs(side) <= rounding * a.norm() * b.norm())
              throw SceneError("'" + part + "': an arc of 180 degrees; divide it");
            one.turn = side > 0 ? 1 : -1;
          }
        segments.push_back(one);
      }
    if (segments.empty())
      throw SceneError("a profile has at least two points");
    if (!is_reversed)
      return;
    std::reverse(segments.begin(), segments.end());
    for (Segment &one : segments)
      {
        std::swap(one.begin, one.end);
        one.turn *= -1;
      }
  }



  // The centre of an arc that goes around it anticlockwise is on its left.
  Tensor<1, 2>
  ProfileCurve::Segment::normal(const Point<2> &at) const
  {
    if (turn != 0)
      {
        const Tensor<1, 2> out = at - centre;
        return -turn * out / out.norm();
      }
    const Tensor<1, 2> along = end - begin;
    return Tensor<1, 2>({-along[1], along[0]}) / along.norm();
  }



  Point<2>
  ProfileCurve::Segment::foot(const Point<2> &x) const
  {
    if (turn == 0)
      {
        const Tensor<1, 2> along = end - begin;
        const double       share = (x - begin) * along / along.norm_square();
        return share <= 0 ? begin : share >= 1 ? end : begin + share * along;
      }
    // The arc is within the wedge of begin and end, which is less than half a circle.
    const Tensor<1, 2> a = begin - centre, b = end - centre, r = x - centre;
    if (r.norm() > 0 && turn * cross(a, r) >= 0 && turn * cross(r, b) >= 0)
      return centre + a.norm() / r.norm() * r;
    return x.distance(begin) <= x.distance(end) ? begin : end;
  }



  ProfileCurve::Foot
  ProfileCurve::closest(const Point<2> &x) const
  {
    double       least = std::numeric_limits<double>::max();
    Point<2>     at;
    unsigned int which = 0;
    for (unsigned int i = 0; i < segments.size(); ++i)
      {
        const Point<2> foot = segments[i].foot(x);
        if (const double distance = x.distance(foot); distance < least)
          {
            least = distance;
            at    = foot;
            which = i;
          }
      }
    const Segment &one   = segments[which];
    const double   size  = one.begin.distance(one.end);
    const bool     first = at.distance(one.begin) <= rounding * size,
               last      = at.distance(one.end) <= rounding * size;
    // At a corner both segments have the same foot. A curve may be closed.
    const bool     is_closed = segments.back().end.distance(segments[0].begin) <= rounding * size;
    const Segment *other     = nullptr;
    if (first && (which > 0 || is_closed))
      other = &segments[which > 0 ? which - 1 : segments.size() - 1];
    if (last && (which + 1 < segments.size() || is_closed))
      other = &segments[which + 1 < segments.size() ? which + 1 : 0];
    Tensor<1, 2> mean = one.normal(at);
    if (other)
      mean += other->normal(at);
    const double sign = (x - at) * mean < 0 ? -1. : 1.;
    Foot         result{sign * least, mean / mean.norm(), 0};
    if (first || last)
      {
        if (least > rounding * size)
          result.normal = sign * (x - at) / least;
        return result;
      }
    // The gap is the distance from the centre less the radius, or the opposite.
    result.normal = one.normal(at);
    if (one.turn != 0)
      if (const double r = x.distance(one.centre); r > 0)
        result.curvature = -one.turn / r;
    return result;
  }
} // namespace Signorini
