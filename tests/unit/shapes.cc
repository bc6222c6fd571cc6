// SPDX-License-Identifier: Apache-2.0
// Obstacles whose shape changes with time are at each time those with the numbers of that time.
#include "contact/obstacles/shapes.h"

#include <signorini/base/scene_error.h>
#include <signorini/parameters/section.h>

#include <doctest/doctest.h>

#include <utility>

using namespace Signorini;
using dealii::Point;

namespace
{
  using Keys = std::vector<std::pair<std::string, std::string>>;

  template <int dim>
  std::unique_ptr<ObstacleShape<dim>>
  shape(const std::string &name, const Keys &keys)
  {
    RawSection raw;
    for (const auto &[key, text] : keys)
      override_value(raw, key + "=" + text);
    Section section(raw);
    auto    result = make_shape<dim>(name);
    result->declare(section);
    return result;
  }

  template <int dim>
  void
  check_same(const ObstacleShape<dim> &a, const ObstacleShape<dim> &b, const Point<dim> &x)
  {
    for (const auto &[one, two] : {std::make_pair(a.closest(x), b.closest(x)),
                                   std::make_pair(a.closest_point(x, 1), b.closest_point(x, 1))})
      {
        CHECK(one.gap == doctest::Approx(two.gap).epsilon(1e-14));
        CHECK((one.normal - two.normal).norm() < 1e-14);
        CHECK((one.curvature - two.curvature).norm() < 1e-14);
      }
  }

  template <int dim>
  void
  check_growth(const std::string &name, const Keys &now, const Keys &in_time)
  {
    CAPTURE(name);
    const auto fixed = shape<dim>(name, now), grown = shape<dim>(name, in_time);
    CHECK_FALSE(fixed->depends_on_time());
    CHECK(grown->depends_on_time());
    Point<dim> x;
    x[0]       = 0.9;
    x[dim - 1] = -1.4;
    CHECK(grown->closest(x).gap != doctest::Approx(fixed->closest(x).gap).epsilon(1e-3));
    grown->set_time(0.5);
    check_same(*fixed, *grown, x);
  }

  template <int dim>
  void
  check_all()
  {
    check_growth<dim>("sphere", {{"Radius", "1.2"}}, {{"Radius", "1 + 0.4*t"}});
    check_growth<dim>("cylinder",
                      {{"Radius", "1.2"}, {"Hollow", "yes"}},
                      {{"Radius", "1 + 0.4*t"}, {"Hollow", "yes"}});
    check_growth<dim>("paraboloid", {{"Radius", "1.2"}}, {{"Radius", "1 + 0.4*t"}});
    check_growth<dim>("cone", {{"Angle", "12"}}, {{"Angle", "10 + 4*t"}});
    check_growth<dim>("punch",
                      {{"Radius", "0.5"}, {"Edge radius", "0.2"}},
                      {{"Radius", "0.4 + 0.2*t"}, {"Edge radius", "0.4*t"}});
  }
} // namespace



TEST_CASE("obstacles whose radius or angle is a formula in t")
{
  check_all<2>();
  check_all<3>();
}



TEST_CASE("numbers of shapes must be in their range at all times, and alike at all places")
{
  CHECK_THROWS_WITH_AS(shape<2>("sphere", {{"Radius", "t"}}),
                       doctest::Contains("Radius = t: must be > 0 at t = 0"),
                       SceneError);
  CHECK_THROWS_WITH_AS(shape<2>("sphere", {{"Radius", "-1"}}),
                       doctest::Contains("must be > 0"),
                       SceneError);
  CHECK_THROWS_WITH_AS(shape<3>("cone", {{"Angle", "10 + x"}}),
                       doctest::Contains("must not depend on x, y or z"),
                       SceneError);
  const auto shrinking = shape<3>("cylinder", {{"Radius", "1 - t"}});
  CHECK_NOTHROW(shrinking->set_time(0.5));
  CHECK_THROWS_WITH_AS(shrinking->set_time(1),
                       doctest::Contains("Radius = 1 - t: the value at t = 1 is 0; it must be > 0"),
                       SceneError);
}
