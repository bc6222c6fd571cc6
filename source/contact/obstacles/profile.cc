// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/profile_curve.h"
#include "contact/obstacles/shapes.h"
#include <signorini/base/scene_error.h>
#include <signorini/parameters/section.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <optional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
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
                    at.curvature * (unit() - outer_product(at.normal, at.normal))};
          }
        else
          {
            const Tensor<1, dim> r = x - origin, along = axis / axis.norm();
            Tensor<1, dim>       first = along, second, third;
            Point<2>             in_plane;
            if (is_turned)
              {
                const Tensor<1, dim> across = r - (r * along) * along;
                first    = across.norm() > 0 ? across / across.norm() : any_normal(along);
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
      static SymmetricTensor<2, dim>
      unit()
      {
        return unit_symmetric_tensor<dim>();
      }

      /// A unit vector across another one.
      static Tensor<1, dim>
      any_normal(const Tensor<1, dim> &v)
      {
        Tensor<1, dim> other;
        other[std::abs(v[0]) < 0.9 * v.norm() ? 0 : 1] = 1;
        other -= (other * v) / v.norm_square() * v;
        return other / other.norm();
      }

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
