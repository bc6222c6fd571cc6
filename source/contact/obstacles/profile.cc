// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/shapes.h"
#include "contact/search/vectors_across.h"
#include <signorini/base/scene_error.h>
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>
#include <signorini/parameters/section.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A curve in the plane, of straight lines and circular arcs one after the other. Outside is on
    /// the left of the way along it.
    class ProfileCurve
    {
    public:
      /// The closest point of the curve, seen from a point.
      struct Foot
      {
        double       gap;           ///< distance [length], positive outside
        Tensor<1, 2> normal;        ///< unit, to the outside
        double       curvature = 0; ///< of the parallel curve through the point; 0 at corners
      };

      /// Throws SceneError for a text that is not understood, for an end of an arc that is not on
      /// its circle, and for arcs of 180 degrees or more.
      /// @param text the start "x, y", then the ends of lines "x, y" and of arcs "x, y, cx, cy"
      /// with their centre, separated by ';'
      /// @param is_reversed the other side is outside
      explicit ProfileCurve(const std::string &text, bool is_reversed = false);

      /// The closest point. At corners the sign is that of the mean of both normals.
      Foot
      closest(const Point<2> &x) const;

    private:
      struct Segment
      {
        Point<2> begin, end, centre;
        /// 1 for arcs that go around their centre anticlockwise, -1 for others, 0 for lines.
        double turn = 0;

        /// The unit normal to the left at a point of the segment.
        Tensor<1, 2>
        normal(const Point<2> &at) const;
        /// The closest point.
        Point<2>
        foot(const Point<2> &x) const;
      };

      std::vector<Segment> segments;
    };



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



    /// A curve of lines and arcs: in the plane itself, in space moved along a straight line, or
    /// turned about an axis.
    template <int dim>
    class Profile : public ObstacleShape<dim>
    {
    public:
      Profile()
      {
        axis[0]            = 1;
        generator[dim - 1] = 1;
      }

      void
      declare(Section &section) override
      {
        section.add(
          "Profile",
          text,
          "start x, y; then ends of lines x, y, and of arcs x, y, cx, cy with their centre, "
          "separated by ';'; outside is on the left of the way [length]");
        section.add("Flip", is_reversed, "yes: outside is on the right of the way");
        if (dim == 3)
          {
            section.add(
              "Revolved",
              is_turned,
              "yes: the profile has the coordinates r, z and is turned about the Axis, which is z; "
              "no: it is moved along the Generator");
            section.add("Origin",
                        origin,
                        "where both coordinates of the profile are zero [length]");
            section.add(
              "Axis",
              axis,
              "of the first coordinate of the profile, or that it is turned about; any length");
            section.add("Generator",
                        generator,
                        "along which the profile is moved, normal to the Axis; any length");
          }
        if (!section.reading())
          return;
        try
          {
            curve.emplace(text, is_reversed);
          }
        catch (const SceneError &error)
          {
            section.fail("Profile", error.what());
          }
        if (dim == 3 && axis.norm() == 0)
          section.fail("Axis", "must not be zero");
        if (dim == 3 && !is_turned && generator.norm() == 0)
          section.fail("Generator", "must not be zero");
        if (dim == 3 && !is_turned &&
            std::abs(axis * generator) > 1e-8 * axis.norm() * generator.norm())
          section.fail("Generator", "must be normal to the Axis");
      }

      // In the plane of the profile the gap is that of the curve; along the generator it is
      // constant, and around an axis the curvature is the radial part of the normal over the
      // radius.
      ObstaclePoint<dim>
      closest(const Point<dim> &x) const override
      {
        if constexpr (dim == 2)
          {
            const ProfileCurve::Foot at = curve->closest(x);
            return {at.gap,
                    at.normal,
                    at.curvature *
                      (unit_symmetric_tensor<dim>() - outer_product(at.normal, at.normal))};
          }
        else
          {
            const Tensor<1, dim> r = x - origin, along = axis / axis.norm();
            Tensor<1, dim>       first = along, second, third;
            Point<2>             in_plane;
            if (is_turned)
              {
                const Tensor<1, dim> across = r - (r * along) * along;
                first    = across.norm() > 0 ? across / across.norm() : vectors_across(along)[0];
                second   = along;
                in_plane = Point<2>(across.norm(), r * along);
              }
            else
              {
                second   = cross_product_3d(generator / generator.norm(), along);
                in_plane = Point<2>(r * first, r * second);
              }
            third                       = cross_product_3d(first, second);
            const ProfileCurve::Foot at = curve->closest(in_plane);
            const Tensor<1, dim>     n  = at.normal[0] * first + at.normal[1] * second,
                                 t      = at.normal[1] * first - at.normal[0] * second;
            Tensor<2, dim> curvature    = at.curvature * outer_product(t, t);
            if (is_turned)
              curvature += (in_plane[0] > 0 ? at.normal[0] / in_plane[0] : at.curvature) *
                           outer_product(third, third);
            return {at.gap, n, curvature};
          }
      }

    private:
      std::string                 text        = "0, 0; 1, 0";
      bool                        is_reversed = false, is_turned = false;
      Point<dim>                  origin, axis, generator;
      std::optional<ProfileCurve> curve = ProfileCurve(text);
    };
  } // namespace

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  make_profile()
  {
    return std::make_unique<Profile<dim>>();
  }

  template std::unique_ptr<ObstacleShape<2>>
  make_profile();
  template std::unique_ptr<ObstacleShape<3>>
  make_profile();
} // namespace Signorini
