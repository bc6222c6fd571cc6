// SPDX-License-Identifier: Apache-2.0
// The linearisation of stresses against differences.

#include "solid/stress_state.h"

#include <doctest/doctest.h>

#include "contact_cases.h"

using namespace TestScene;

namespace
{
  /// A scene of one body of a law, Poisson's ratio and model.
  template <int dim>
  std::vector<std::string>
  one_body(const std::string &deformation, const std::string &nu, const std::string &more)
  {
    return {"Dimension=" + std::to_string(dim),
            "Deformation=" + deformation,
            "Bodies/Names=body",
            "Bodies/body/Mesh=box",
            dim == 2 ? "Bodies/body/Corners=1,0 : 2,1" : "Bodies/body/Corners=0,0,0 : 1,1,1",
            dim == 2 ? "Bodies/body/Subdivisions=2,2" : "Bodies/body/Subdivisions=2,2,2",
            "Bodies/body/Degree=2",
            "Bodies/body/Young's modulus=3",
            "Bodies/body/Poisson's ratio=" + nu,
            more};
  }

  /// Compare the derivatives of all functions of StressState with central differences.
  template <int dim>
  void
  check_derivatives(const std::vector<std::string> &keys)
  {
    const SmallScene<dim> scene(keys);
    Elasticity<dim>      &elasticity = *scene.elasticity;
    auto                 &volumetric = elasticity.volumetric_stress();
    const auto            cell       = elasticity.dof_handler().begin_active();
    if (!cell->is_locally_owned() && !cell->is_ghost())
      return;
    Point<dim> X = cell->center();
    X[0] += 0.05;
    Tensor<2, dim> gradient, change;
    Tensor<1, dim> u, v;
    for (unsigned int i = 0; i < dim; ++i)
      {
        u[i] = 0.1 + 0.05 * i;
        v[i] = -0.3 + 0.4 * i;
        for (unsigned int j = 0; j < dim; ++j)
          {
            gradient[i][j] = 0.15 * std::sin(3. * i + 2 * j + 1);
            change[i][j]   = std::cos(2. * i + 5 * j);
          }
      }
    // The coefficients of the volumetric stress are lengths, so that values of this size are large.
    LA::Vector m = volumetric.zero_vector(), q = m;
    for (const auto i : volumetric.owned())
      {
        m(i) = 0.02 * (1 + i % 3);
        q(i) = 0.1 * (1 + i % 2);
      }
    const auto at = [&](const double step) {
      if (!volumetric.empty())
        {
          LA::Vector there = m;
          there.add(step, q);
          volumetric.set_coefficients(there);
        }
      return stress_state<dim>(elasticity, *cell, gradient + step * change, u + step * v, X);
    };
    constexpr double  step = 1e-5;
    const StressState here = at(0), plus = at(step), minus = at(-step);
    const double      of_q =
      volumetric.empty() ? 0. : volumetric.value(*cell, X, volumetric.with_ghosts(q));
    const Tensor<2, 3> G      = gradient_of_change(elasticity.model(), change, v, X);
    const auto         cauchy = [](const StressState &state) {
      return symmetrize(state.stress * transpose(state.F)) / determinant(state.F);
    };
    CHECK((here.change_of_stress(G, of_q) - (plus.stress - minus.stress) / (2 * step)).norm() <
          1e-7 * here.change_of_stress(G, of_q).norm());
    CHECK(
      (here.change_of_cauchy_stress(G, of_q) - (cauchy(plus) - cauchy(minus)) / (2 * step)).norm() <
      1e-7 * here.change_of_stress(G, of_q).norm());
    CHECK(
      here.change_of_volume_residual(G, of_q) ==
      doctest::Approx((plus.volume_residual - minus.volume_residual) / (2 * step)).epsilon(1e-7));
    // The energy has the stress and the residual of the volume as derivatives.
    CHECK(scalar_product(here.stress, G) + here.volume_residual * of_q ==
          doctest::Approx((plus.energy - minus.energy) / (2 * step)).epsilon(1e-7));
  }
} // namespace

TEST_CASE("the stress and its linearisation are those of the energy")
{
  for (const std::string deformation : {"small", "finite"})
    for (const std::string nu : {"0.3", "0.499"})
      {
        const std::string form =
          std::string("Bodies/body/Formulation=") + (nu == "0.3" ? "displacement" : "mixed");
        CAPTURE(deformation);
        CAPTURE(nu);
        check_derivatives<2>(one_body<2>(deformation, nu, form));
        check_derivatives<3>(one_body<3>(deformation, nu, form));
        auto axisymmetric = one_body<2>(deformation, nu, form);
        axisymmetric.push_back("Model=axisymmetric");
        check_derivatives<2>(axisymmetric);
        if (nu == "0.3")
          {
            auto sheet = one_body<2>(deformation, nu, form);
            sheet.push_back("Model=plane stress");
            check_derivatives<2>(sheet);
          }
      }
}
