// SPDX-License-Identifier: Apache-2.0
// Stored energies of large deformation: what they exert against what they store.

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
