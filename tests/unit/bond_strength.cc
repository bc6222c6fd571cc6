// SPDX-License-Identifier: Apache-2.0
// Bonds that fail: the criterion, and a crack along the bond of two strips.
#include "contact/laws/bonds.h"
#include <signorini/base/scene_error.h>
#include <signorini/contact/bond_strength.h>

#include <doctest/doctest.h>

#include <cmath>

#include "stepped_scene.h"

using namespace TestScene;

namespace
{
  /// Two strips that are pulled apart at x = 0, up to the opening 2; the crack begins at x = 6.
  Lines
  strips(const unsigned int faces, const std::string &bond)
  {
    const std::string n = std::to_string(faces) + ",1";
    return {"Bodies/Names=lower,upper",
            "Bodies/lower/Mesh=box",
            "Bodies/lower/Corners=0,-1 : 20,0",
            "Bodies/lower/Subdivisions=" + n,
            "Bodies/lower/Degree=2",
            "Bodies/lower/Young's modulus=1000",
            "Bodies/lower/Poisson's ratio=0.3",
            "Bodies/upper/Mesh=box",
            "Bodies/upper/Corners=0,0 : 20,1",
            "Bodies/upper/Subdivisions=" + n,
            "Bodies/upper/Degree=2",
            "Bodies/upper/Young's modulus=1000",
            "Bodies/upper/Poisson's ratio=0.3",
            "Supports/Names=up,down,right",
            "Supports/up/Boundaries=upper.left",
            "Supports/up/Displacement=free; t",
            "Supports/down/Boundaries=lower.left",
            "Supports/down/Displacement=free; -t",
            "Supports/right/Boundaries=lower.right,upper.right",
            "Supports/right/Displacement=0; 0",
            "Contact pairs/Names=bond",
            "Contact pairs/bond/Slave=upper.bottom",
            "Contact pairs/bond/Master=lower.top",
            "Contact pairs/bond/Law=tied",
            "Contact pairs/bond/Pressure-overclosure=linear",
            "Contact pairs/bond/Normal stiffness=20",
            "Contact pairs/bond/Tangential stiffness=20",
            "Contact pairs/bond/Strength=" + bond};
  }

  /// The area whose bond is intact.
  double
  bonded_area(SteppedScene<2> &steps)
  {
    const GapOperator &contact = steps.scene.gap_operator();
    double             area    = 0;
    for (const auto i : contact.weight.locally_owned_elements())
      if (status_of(contact.coefficients.least_status(i)) == ContactStatus::stick)
        area += contact.weight(i);
    return Utilities::MPI::sum(area, MPI_COMM_WORLD);
  }

  /// The same after some load steps up to t = 1.
  double
  area_after(const Lines &lines, const unsigned int n_steps, const std::string &method)
  {
    SteppedScene<2> steps(lines);
    steps.scene.use({"Method=" + method, "Contact geometry=reference"});
    steps.start();
    for (unsigned int i = 1; i <= n_steps; ++i)
      REQUIRE_MESSAGE(steps.solve(i / double(n_steps)), steps.log.str());
    return bonded_area(steps);
  }
} // namespace



TEST_CASE("the criterion of a bond")
{
  const SmallScene<2>    scene(strips(20, "if(x < 6, 0, 3)") +
                            Lines{"Contact pairs/bond/Shear strength=5"});
  const BondStrength<2> &bond = scene.decisions.pairs[0].strength;
  const Point<2>         x(10, 0);
  CHECK(bond.utilisation(x, -1.5, 0) == doctest::Approx(0.5));
  CHECK(bond.utilisation(x, 100, 0) == 0);
  CHECK(bond.utilisation(x, 100, 4) == doctest::Approx(0.8));
  CHECK(bond.utilisation(x, -1.8, 4) == doctest::Approx(1));
  CHECK(bond.is_absent(Point<2>(5, 0)));
  CHECK_FALSE(bond.is_absent(x));
  CHECK_THROWS_AS(SmallScene<2>(strips(20, "t")), SceneError);
  SmallScene<2> negative(strips(20, "x - 6"));
  negative.use({"Method=penalty"});
  LA::Vector intact = negative.gap_operator().zero();
  intact            = 1;
  CHECK_THROWS_AS(negative.contact->set_bonds(intact), SceneError);
}



// Fracture energy 0.4^2/40 = 0.004: with E I = 91.6 and beta = 0.575, (2.37) has the tip at 11.5
// for the opening 2. The strips are short, and their shear counts.
TEST_CASE("a crack runs as far in two load steps as in ten, and for all methods")
{
  const Lines  lines = strips(40, "if(x < 6, 0, 1.2)");
  const double face = 0.5, reference = area_after(lines, 10, "Lagrange multiplier");
  CHECK(reference == doctest::Approx(20 - 10.55).epsilon(0.15));
  CHECK(std::abs(area_after(lines, 2, "Lagrange multiplier") - reference) < 1.01 * face);
  CHECK(std::abs(area_after(lines, 2, "penalty") - reference) < 1.01 * face);
  CHECK(std::abs(area_after(lines, 2, "Nitsche") - reference) < 2.01 * face);
}



// With the forces taken back the bond does not heal, and the strips close on each other.
TEST_CASE("a bond that has failed stays so")
{
  Lines lines = strips(40, "if(x < 6, 0, 1.2)");
  for (std::string &line : lines)
    for (const auto &[from, to] : {std::make_pair("=free; t", "=free; t*(2 - t)"),
                                   std::make_pair("=free; -t", "=free; -t*(2 - t)")})
      if (const auto at = line.find(from); at != std::string::npos)
        line.replace(at, line.size() - at, to);
  SteppedScene<2> steps(lines);
  steps.scene.use({"Contact geometry=reference"});
  steps.start();
  REQUIRE(steps.solve(0.5));
  REQUIRE(steps.solve(1));
  const double area = bonded_area(steps);
  CHECK(area < 13);
  REQUIRE(steps.solve(2));
  CHECK(bonded_area(steps) == area);
  // On a mesh whose nodes hang at the surface, the bond is where it was.
  steps.refine_some();
  CHECK(bonded_area(steps) == doctest::Approx(area).epsilon(0.05));
}
