// SPDX-License-Identifier: Apache-2.0
// How far contact is looked for: no farther than surfaces are expected to come closer, farther as
// soon as they do, on finer meshes as far as the last solution tells; and initial overlaps are
// found however deep they are.

#include <doctest/doctest.h>

#include <algorithm>

#include "contact_cases.h"

using namespace TestScene;

namespace
{
  constexpr double slope = 0.4, motion = 0.01, search_distance = 0.3;

  /// A block above an inclined plane, which it touches at its edge x = 0.
  Lines
  wedge()
  {
    return Lines{"Dimension=2",
                 "Bodies/Names=block",
                 "Bodies/block/Corners=0,0 : 1,1",
                 "Bodies/block/Subdivisions=50,2",
                 "Bodies/block/Young's modulus=10",
                 "Bodies/block/Poisson's ratio=0.3",
                 "Obstacles/Names=plane",
                 "Obstacles/plane/Shape=plane",
                 "Obstacles/plane/Point=0,0",
                 "Obstacles/plane/Normal=" + std::to_string(slope) + ",1"} +
           pair("block.bottom", "plane") +
           Lines{"Contact pairs/pair/Search distance=" + std::to_string(search_distance)} +
           fixed("block.top", "0; -" + std::to_string(motion) + "*t");
  }

  double
  largest_gap(const SmallScene<2> &scene)
  {
    double largest = 0;
    for (const ContactPoint<2> &point : scene.contact->surfaces()[0].points)
      largest = std::max(largest, point.gap);
    return Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }

  /// Everything moves down.
  LA::Vector
  lowered(const SmallScene<2> &scene, const double distance)
  {
    LA::Vector u = scene.elasticity->zero_vector();
    for (const auto i : u.locally_owned_elements())
      u(i) = i % 2 == 1 ? -distance : 0.;
    u.compress(VectorOperation::insert);
    return u;
  }
} // namespace



TEST_CASE("candidates are as far away as surfaces may come closer")
{
  SmallScene<2> scene(wedge());
  scene.use({"Method=penalty", "Contact geometry=reference"});
  const double face = 0.02 * slope, closing = largest_expected_approach(scene.scene, *scene.mesh);
  Configuration<2> rest(*scene.elasticity);
  REQUIRE(closing < search_distance / 4);
  CHECK(closing >= motion);
  CHECK(largest_gap(scene) <= closing + face);
  CHECK(largest_gap(scene) >= (closing - face) / std::hypot(1, slope));

  SUBCASE("more of them when they come closer than was expected")
  {
    CHECK(!scene.contact->search_radius_exceeded(lowered(scene, closing / 2)));
    CHECK(scene.contact->search_radius_exceeded(lowered(scene, 2 * closing)));
    scene.contact->build(rest);
    CHECK(largest_gap(scene) > 3 * closing);
    CHECK(!scene.contact->search_radius_exceeded(lowered(scene, 2 * closing)));
  }
  SUBCASE("but none beyond the search distance")
  {
    CHECK(scene.contact->search_radius_exceeded(lowered(scene, 0.5)));
    scene.contact->build(rest);
    CHECK(largest_gap(scene) <= search_distance + face);
    CHECK(largest_gap(scene) > search_distance - 2 * face);
    CHECK(!scene.contact->search_radius_exceeded(lowered(scene, 0.5)));
  }
  SUBCASE("fewer of them once a solution is known")
  {
    const double small = closing / 10;
    CHECK(!scene.contact->search_radius_exceeded(lowered(scene, small)));
    scene.contact->invalidate();
    scene.contact->build(rest);
    CHECK(largest_gap(scene) <= 1.5 * small + face);
    CHECK(!scene.contact->search_radius_exceeded(lowered(scene, small)));
    CHECK(scene.contact->search_radius_exceeded(lowered(scene, 2 * small)));
    scene.contact->build(rest);
    CHECK(largest_gap(scene) > closing / 2);
  }
}



TEST_CASE("initial overlaps are found though nothing moves")
{
  const auto check = [](auto dim, const std::string &lower, const std::string &upper) {
    constexpr int d = decltype(dim)::value;
    const Lines   lines =
      materials("lower", "upper") + pair("upper.bottom", "lower.top") +
      Lines{"Dimension=" + std::to_string(d),
            "Bodies/lower/Corners=" + lower,
            "Bodies/lower/Subdivisions=" + std::string(d == 2 ? "9,9" : "9,9,9"),
            "Bodies/upper/Corners=" + upper,
            "Bodies/upper/Subdivisions=" + std::string(d == 2 ? "10,10" : "10,10,10")} +
      fixed("lower.bottom, upper.top", d == 2 ? "0; 0" : "0; 0; 0");
    for (const std::string distance : {"0", "0.5"})
      {
        CAPTURE(distance);
        SmallScene<d> scene(lines + Lines{"Contact pairs/pair/Search distance=" + distance});
        scene.use({"Method=penalty", "Contact geometry=reference"});
        const ContactSurface<d> &surface = scene.contact->surfaces()[0];
        double                   area    = 0;
        for (const ContactPoint<d> &point : surface.points)
          area += point.weight;
        CHECK(surface.overlap == doctest::Approx(0.3));
        CHECK(Utilities::MPI::sum(area, MPI_COMM_WORLD) == doctest::Approx(1));
      }
    CHECK_THROWS_WITH_AS(SmallScene<d>(lines + Lines{"Contact pairs/pair/Search distance=0.2"})
                           .use({"Method=penalty"}),
                         doctest::Contains("deeper than its Search distance"),
                         SceneError);
  };
  check(std::integral_constant<int, 2>(), "0,0 : 1,1", "0,0.7 : 1,1.7");
  check(std::integral_constant<int, 3>(), "0,0,0 : 1,1,1", "0,0,0.7 : 1,1,1.7");
}
