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



namespace
{
  /// The foot is a point of the shape: the gap is the distance to it, and its derivatives are
  /// normal and curvature, by central differences.
  template <int dim>
  void
  check_derivatives(const ObstacleShape<dim> &shape, const Point<dim> &x)
  {
    constexpr double         h  = 1e-5;
    const ObstaclePoint<dim> at = shape.closest(x);
    CHECK(at.normal.norm() == doctest::Approx(1));
    for (unsigned int d = 0; d < dim; ++d)
      {
        Point<dim> forth = x, back = x;
        forth[d] += h;
        back[d] -= h;
        const ObstaclePoint<dim> after = shape.closest(forth), before = shape.closest(back);
        CHECK((after.gap - before.gap) / (2 * h) == doctest::Approx(at.normal[d]).epsilon(1e-7));
        for (unsigned int e = 0; e < dim; ++e)
          CHECK(std::abs((after.normal[e] - before.normal[e]) / (2 * h) - at.curvature[e][d]) <
                1e-7);
      }
  }

  // A floor up to x = 2, a fillet of radius 1 about (2, 1), and a wall at x = 3; outside is above.
  const std::string fillet = "-5, 0; 2, 0; 3, 1, 2, 1; 3, 6";
} // namespace



TEST_CASE("profiles of lines and arcs, in the plane, moved along a line and turned about an axis")
{
  const auto plane = shape<2>("profile", {{"Profile", fillet}});
  for (const auto &[x, gap] :
       std::vector<std::pair<Point<2>, double>>{{{0., 0.5}, 0.5},
                                                {{0., -0.5}, -0.5},
                                                {{2.5, 4.}, 0.5},
                                                {{3.2, 4.}, -0.2},
                                                {{2.3, 0.6}, 0.5},
                                                {{2.6, 0.2}, 0.},
                                                {{2.9, 0.1}, 1 - std::hypot(0.9, 0.9)},
                                                {{-6., 1.}, std::sqrt(2.)}})
    {
      CHECK(plane->closest(x).gap == doctest::Approx(gap));
      if (x[0] > -5) // beside the end, a corner, curvatures are left out
        check_derivatives(*plane, Point<2>(x[0] + 1e-3, x[1] + 2e-3));
    }
  // The other side, and the other way.
  const Point<2> x(2.3, 0.6);
  CHECK(shape<2>("profile", {{"Profile", fillet}, {"Flip", "yes"}})->closest(x).gap ==
        doctest::Approx(-0.5));
  CHECK(shape<2>("profile", {{"Profile", "3, 6; 3, 1; 2, 0, 2, 1; -5, 0"}})->closest(x).gap ==
        doctest::Approx(-0.5));

  // Moved along y: local y is across both.
  const auto moved = shape<3>(
    "profile",
    {{"Profile", fillet}, {"Origin", "1, 2, 3"}, {"Axis", "0, 0, 2"}, {"Generator", "0, 1, 0"}});
  for (const Point<2> &q : {Point<2>(0.2, 0.5), Point<2>(2.3, 0.6), Point<2>(2.9, 0.1)})
    for (const double along : {-3., 5.})
      {
        // z = generator x axis is x.
        const Point<3> there(1 + q[1], 2 + along, 3 + q[0]);
        CHECK(moved->closest(there).gap == doctest::Approx(plane->closest(q).gap));
        check_derivatives(*moved, there);
      }

  // A bowl: turned about z, the floor, a fillet and the wall of a cylinder.
  const auto turned = shape<3>("profile",
                               {{"Profile", "0, 0; 2, 0; 3, 1, 2, 1; 3, 6"},
                                {"Revolved", "yes"},
                                {"Axis", "0, 0, 1"}});
  for (const Point<2> &q :
       {Point<2>(0.2, 0.5), Point<2>(2.3, 0.6), Point<2>(2.7, 3.), Point<2>(3.4, 2.)})
    for (const double angle : {0.3, 2., 4.})
      {
        const Point<3> there(q[0] * std::cos(angle), q[0] * std::sin(angle), q[1]);
        CHECK(turned->closest(there).gap == doctest::Approx(plane->closest(q).gap));
        check_derivatives(*turned, there);
      }
  CHECK(turned->closest(Point<3>(0, 0, 0.5)).gap == doctest::Approx(0.5));
}



// At a corner the nearest segment alone would give the wrong sign.
TEST_CASE("profiles have an inside and an outside at corners")
{
  // A step: outside is above and on the left; the angle at (1, 0) is sharp.
  const auto tooth = shape<2>("profile", {{"Profile", "0, 0; 1, 0.2; 0, 0.4"}});
  CHECK(tooth->closest(Point<2>(1.5, 0.2)).gap < 0);
  CHECK(tooth->closest(Point<2>(0.5, 0.2)).gap > 0);
  const auto edge = shape<2>("profile", {{"Profile", "0, 0.4; 1, 0.2; 0, 0"}});
  CHECK(edge->closest(Point<2>(1.5, 0.2)).gap == doctest::Approx(0.5));
  CHECK(edge->closest(Point<2>(0.5, 0.2)).gap < 0);
  // A closed square, outside is out of it.
  const auto square = shape<2>("profile", {{"Profile", "0, 0; 0, 1; 1, 1; 1, 0; 0, 0"}});
  CHECK(square->closest(Point<2>(-1, -1)).gap == doctest::Approx(std::sqrt(2.)));
  CHECK(square->closest(Point<2>(0.5, 0.2)).gap == doctest::Approx(-0.2));
  for (const auto &[text, message] : {std::make_pair("0, 0", "at least two points"),
                                      std::make_pair("0, 0; 1, 0, 0, 0", "from its centre"),
                                      std::make_pair("0, 0; 2, 0, 1, 0", "180 degrees"),
                                      std::make_pair("0, 0; 1", "is not the end x, y of a line"),
                                      std::make_pair("0, a; 1, 1", "'a' is no number")})
    CHECK_THROWS_WITH_AS(shape<2>("profile", {{"Profile", text}}),
                         doctest::Contains(message),
                         SceneError);
}
