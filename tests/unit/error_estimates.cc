// SPDX-License-Identifier: Apache-2.0
// Recovered stresses, the errors of quantities, and the bars that are made of them.

#include "accuracy/error_control.h"
#include "accuracy/error_parts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "contact_cases.h"

using namespace TestScene;

namespace
{
  /// u_x = x^(degree + 1) in n cells a direction of the unit square or cube, nu = 0: at the
  /// superconvergent points the interpolant has the gradient of u, so that recovery is exact, in
  /// cells at boundaries too.
  template <int dim>
  void
  check_recovery(const unsigned int degree, const double exact_over_E)
  {
    constexpr unsigned int n = 4;
    const double           E = 7;
    const SmallScene<dim>  scene(
      {"Dimension=" + std::to_string(dim),
        "Bodies/Names=body",
        "Bodies/body/Mesh=box",
       dim == 2 ? "Bodies/body/Corners=0,0 : 1,1" : "Bodies/body/Corners=0,0,0 : 1,1,1",
       dim == 2 ? "Bodies/body/Subdivisions=4,4" : "Bodies/body/Subdivisions=4,4,4",
        "Bodies/body/Degree=" + std::to_string(degree),
        "Bodies/body/Young's modulus=" + std::to_string(E),
        "Bodies/body/Poisson's ratio=0"});
    const LA::Vector u      = interpolant(scene, [&](const Point<dim> &x, auto) {
      Tensor<1, dim> value;
      value[0] = std::pow(x[0], degree + 1);
      return value;
    });
    const CellErrors errors = cell_errors(*scene.elasticity, u, {{u, {}}});
    double energy = std::accumulate(errors.energy.begin(), errors.energy.end(), 0.), product = 0;
    product            = std::accumulate(errors.products[0].begin(), errors.products[0].end(), 0.);
    const double exact = E * exact_over_E * std::pow(1. / n, 2 * degree);
    CHECK(Utilities::MPI::sum(energy, MPI_COMM_WORLD) == doctest::Approx(exact).epsilon(1e-5));
    CHECK(Utilities::MPI::sum(product, MPI_COMM_WORLD) == doctest::Approx(exact).epsilon(1e-5));
  }

  /// A mesh on which the error is that, and known up to a factor.
  QuantityEstimate
  on_mesh(const double error, const double effectivity = 1)
  {
    QuantityEstimate one;
    one.value                = 1 - error;
    one.parts.discretisation = effectivity * error;
    one.absolute             = std::abs(effectivity * error);
    return one;
  }
} // namespace

TEST_CASE("recovered stresses tell the error of interpolation")
{
  // int (u - I u)'^2 dx: h^2/3 of x^2, h^4/20 of x^3.
  check_recovery<2>(1, 1. / 3);
  check_recovery<3>(1, 1. / 3);
  check_recovery<2>(2, 1. / 20);
  check_recovery<3>(2, 1. / 20);
}

TEST_CASE("bars hold what is left, also where estimates are half of it")
{
  for (const double effectivity : {0.5, 1., 1.5})
    {
      ErrorHistory history;
      for (const double error : {0.1, 0.05, 0.025})
        history.add(on_mesh(error, effectivity));
      CHECK(history.last_bounded().error_bound > 0.025 * std::min(1., effectivity * 1.49));
      CHECK(history.last_bounded().error_bound < 0.1);
    }
  ErrorHistory history;
  for (const double error : {0.1, 0.05, 0.025})
    history.add(on_mesh(error, 1.1));
  const auto better = history.extrapolated();
  REQUIRE(better);
  CHECK(std::abs(better->value - 1) < better->error_bound);
  CHECK(better->error_bound < history.last_bounded().error_bound);
  CHECK(!history.diverges());
}

TEST_CASE("values without a limit are seen")
{
  ErrorHistory singular, slow;
  for (unsigned int n = 0; n < 6; ++n)
    {
      singular.add(on_mesh(-std::pow(2., 0.5 * n)));
      slow.add(on_mesh(-std::pow(2., -0.5 * n)));
    }
  CHECK(singular.diverges());
  CHECK(!slow.diverges());
}

TEST_CASE("what dominates is done")
{
  Goals goals;
  goals.quantities = {"force of pair"};
  goals.targets    = {1e-2};
  const RefinementSettings settings;
  QuantityEstimate         one = on_mesh(0.001);

  ErrorControl fine(goals, settings);
  fine.add({one});
  CHECK(fine.is_met());

  one.parts.enforcement = 0.05;
  ErrorControl soft(goals, settings);
  soft.add({one});
  CHECK(!soft.is_met());
  CHECK(!soft.needs_mesh());
  CHECK(soft.stiffening() > 10);

  one.parts.enforcement = 0;
  one.parts.algebraic   = 0.05;
  ErrorControl loose(goals, settings);
  loose.add({one});
  CHECK(!loose.is_met());
  CHECK(loose.is_met(true));
  CHECK(loose.tolerance(1e-4) < 1e-5);

  ErrorControl coarse(goals, settings);
  coarse.add({on_mesh(0.1)});
  CHECK(coarse.needs_mesh());
  CHECK(coarse.share() > 0.6);
  CHECK(coarse.stiffening() == 1);

  one             = on_mesh(0.001);
  one.parts.model = 0.02;
  ErrorControl at_rest(goals, settings);
  at_rest.add({one});
  CHECK(at_rest.obstacle(false).find("Contact geometry") != std::string::npos);
}
