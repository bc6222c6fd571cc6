// SPDX-License-Identifier: Apache-2.0
// Stored energies of large deformation: what they exert against what they store.

#include "materials/material_law.h"
#include "materials/stored_energies.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace Signorini;
using namespace dealii;

namespace
{
  struct Law
  {
    std::string                         name;
    double                              lambda, mu;
    std::shared_ptr<const Hyperelastic> law;
  };

  const std::vector<Law> &
  laws()
  {
    static const std::vector<Law> list = {
      {"neo-Hooke", 3, 2, std::make_shared<NeoHooke>(3, 2)},
      {"Mooney-Rivlin", 3, 2, std::make_shared<MooneyRivlin>(3, 0.7, 0.3)},
      {"Yeoh", 3, 2, std::make_shared<Yeoh>(3 + 4. / 3, 1, -0.1, 0.05)},
      {"polynomial", 3, 2, std::make_shared<Polynomial>(3 + 4. / 3, 0.7, 0.3, -0.1, 0.05)},
      {"Ogden",
       3,
       2,
       std::make_shared<Ogden>(3, std::vector<std::pair<double, double>>{{1.6, 3}, {0.4, -2}})},
      {"Hencky", 3, 2, std::make_shared<Hencky>(3, 2)},
      {"Saint Venant-Kirchhoff", 3, 2, std::make_shared<SaintVenantKirchhoff>(3, 2)}};
    return list;
  }

  /// C of a random deformation whose gradient differs by about that from the unit.
  SymmetricTensor<2, 3>
  random_deformation(const double size, std::mt19937 &numbers)
  {
    std::uniform_real_distribution<double> number(-size, size);
    Tensor<2, 3>                           F = unit_symmetric_tensor<3>();
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        F[i][j] += number(numbers);
    return symmetrize(transpose(F) * F);
  }

  /// The unit change of a component of a symmetric tensor.
  SymmetricTensor<2, 3>
  direction(const unsigned int component)
  {
    SymmetricTensor<2, 3> result;
    result.access_raw_entry(component) = 1;
    return result;
  }

  void
  check_derivatives(const Hyperelastic &law, const SymmetricTensor<2, 3> &C)
  {
    constexpr double           h     = 1e-5;
    const ConstitutiveResponse state = law.at(C, ResponseOrder::tangent);
    const double               scale = state.tangent.norm();
    for (unsigned int k = 0; k < 6; ++k)
      {
        const auto                 D    = direction(k);
        const ConstitutiveResponse more = law.at(C + h * D, ResponseOrder::tangent),
                                   less = law.at(C - h * D, ResponseOrder::tangent);
        CHECK(std::abs((more.energy - less.energy) / (2 * h) - state.stress * D / 2) <
              1e-9 * scale);
        const auto change = (more.stress - less.stress) / (2 * h) - 0.5 * (state.tangent * D);
        CHECK(change.norm() < 3e-9 * scale);
        for (unsigned int l = 0; l < 6; ++l)
          CHECK(std::abs(direction(l) * (state.tangent * D) - D * (state.tangent * direction(l))) <
                1e-13 * scale);
      }
  }
} // namespace



TEST_CASE("stress and tangent are the derivatives of the stored energy")
{
  std::mt19937 numbers(7);
  for (const Law &one : laws())
    {
      CAPTURE(one.name);
      for (const double size : {1e-3, 0.05, 0.3})
        for (unsigned int i = 0; i < 10; ++i)
          check_derivatives(*one.law, random_deformation(size, numbers));
    }
}



TEST_CASE("stress and tangent where principal stretches are equal, or nearly so")
{
  SymmetricTensor<2, 3> turn = unit_symmetric_tensor<3>();
  turn[0][1]                 = 0.3;
  for (const Law &one : laws())
    {
      CAPTURE(one.name);
      const auto one_of = unit_symmetric_tensor<3>();
      check_derivatives(*one.law, one_of);
      check_derivatives(*one.law, 1.7 * one_of);
      for (const double apart : {0., 1e-12, 1e-9, 1e-6, 3e-6, 1e-5, 1e-4})
        {
          SymmetricTensor<2, 3> C = 0.6 * one_of;
          C[2][2]                 = 1.5;
          check_derivatives(*one.law, C + apart * turn);
          check_derivatives(*one.law, 1.2 * one_of + apart * turn);
        }
    }
}



TEST_CASE("a law with thermal stretches: derivatives, and a heated body is a larger one")
{
  /// Heated by 2, with stretches of 0.8 to 1.4.
  struct Heated : Hyperelastic
  {
    Heated(const std::shared_ptr<const Hyperelastic> &law, const Tensor<1, 3> &alpha)
      : law(with_thermal_stretch(law, StrainMeasure::finite, alpha))
    {}

    ConstitutiveResponse
    at(const SymmetricTensor<2, 3> &C, const ResponseOrder wanted) const override
    {
      return law->response({C, nullptr, 0, 2}, wanted);
    }

    const std::shared_ptr<const ConstitutiveLaw> law;
  };
  const Tensor<1, 3> uniform({0.2, 0.2, 0.2}), by_axes({0.2, 0.1, -0.1});
  constexpr double   s = 1.4;
  std::mt19937       numbers(11);
  for (const Law &one : laws())
    {
      CAPTURE(one.name);
      const SymmetricTensor<2, 3> C = random_deformation(0.1, numbers);
      check_derivatives(Heated(one.law, by_axes), C);
      const auto cold = one.law->at(C, ResponseOrder::tangent),
                 hot  = Heated(one.law, uniform).at(s * s * C, ResponseOrder::tangent);
      CHECK(hot.energy == doctest::Approx(s * s * s * cold.energy).epsilon(1e-12));
      CHECK((hot.stress / s - cold.stress).norm() < 1e-12 * cold.tangent.norm());
      CHECK((s * hot.tangent - cold.tangent).norm() < 1e-12 * cold.tangent.norm());
    }
  const auto            small = with_thermal_stretch(std::make_shared<SaintVenantKirchhoff>(3, 2),
                                          StrainMeasure::small,
                                          by_axes);
  SymmetricTensor<2, 3> free  = unit_symmetric_tensor<3>();
  for (unsigned int i = 0; i < 3; ++i)
    free[i][i] += 2 * by_axes[i] * 2;
  CHECK(small->response({free, nullptr, 0, 2}, ResponseOrder::stress).stress.norm() < 1e-14);
  // The stretch along z would be -0.1.
  CHECK_THROWS_AS(
    Heated(laws()[0].law, by_axes).law->response({free, nullptr, 0, 11}, ResponseOrder::stress),
    std::domain_error);
}



TEST_CASE("at rest all materials are linear elastic, free of stress and energy")
{
  const auto one = unit_symmetric_tensor<3>();
  for (const Law &which : laws())
    {
      CAPTURE(which.name);
      const ConstitutiveResponse state = which.law->at(one, ResponseOrder::tangent);
      const auto                 linear =
        which.lambda * outer_product(one, one) + 2 * which.mu * identity_tensor<3>();
      CHECK(std::abs(state.energy) < 1e-14);
      CHECK(state.stress.norm() < 1e-14);
      CHECK((state.tangent - linear).norm() < 1e-13 * linear.norm());
    }
}
