// SPDX-License-Identifier: Apache-2.0
// Normal stresses of the bodies at contact points, as Nitsche's method takes them; and the forces
// of a pressure.

#include "contact/traction/normal_stress.h"

#include "solid/kernel.h"
#include "solid/rigid_body_modes.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <doctest/doctest.h>

#include <cmath>

#include "small_scene.h"
#include "two_blocks.h"

using namespace Signorini;
using namespace dealii;
using namespace TestScene;

namespace
{
  template <int dim>
  void
  check_bound(const unsigned int degree)
  {
    CAPTURE(dim);
    CAPTURE(degree);
    const TwoBlocks<dim> scene(*make_method("Nitsche"), degree);
    auto                 cell = scene.elasticity.dof_handler().begin_active();
    while (cell != scene.elasticity.dof_handler().end() && !cell->is_locally_owned())
      ++cell;
    if (cell == scene.elasticity.dof_handler().end())
      return;
    const unsigned int                   face = 1;
    const Tensor<1, dim>                 n    = Point<dim>::unit_vector(0);
    NormalStress<dim>                    stress(scene.elasticity);
    std::vector<types::global_dof_index> indices(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(indices);
    stress.reinit(cell);
    const double bound = stress.bound(face, false);

    StiffnessKernel<dim> kernel(scene.mesh,
                                scene.elasticity.finite_elements(),
                                scene.elasticity.model());
    FullMatrix<double>   K;
    kernel.assemble(cell, scene.elasticity.material(cell->material_id()), K);
    const QGauss<dim - 1> rule(degree + 2);
    FullMatrix<double>    M(K.m()); // int (n . sigma n)^2 dA
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const SparseRow row =
          stress.row(unit_point<dim>(cell->reference_cell(), face, rule.point(q)), n, n);
        Vector<double> s(K.m());
        for (const auto &[index, value] : row)
          s[std::find(indices.begin(), indices.end(), index) - indices.begin()] = value;
        FullMatrix<double> outer(K.m());
        outer.outer_product(s, s);
        M.add(rule.weight(q) * cell->face(face)->measure(), outer);
      }

    // The quotient of any displacement is below the bound; power iteration with K + M, whose
    // quotient grows with the other, comes close to it.
    FullMatrix<double> inverse = K;
    for (unsigned int i = 0; i < K.m(); ++i)
      inverse(i, i) += 1e-6 * K.trace() / K.m();
    inverse.gauss_jordan();
    Vector<double> v(K.m()), Mv(K.m());
    for (unsigned int i = 0; i < v.size(); ++i)
      v[i] = std::sin(1. + i * i);
    double quotient = 0;
    for (unsigned int n_steps = 0; n_steps < 300; ++n_steps)
      {
        quotient = M.matrix_norm_square(v) / K.matrix_norm_square(v);
        CHECK(quotient < bound * (1 + 1e-4));
        M.vmult(Mv, v);
        inverse.vmult(v, Mv);
        v /= v.l2_norm();
      }
    CHECK(quotient > 0.98 * bound);
  }
} // namespace

TEST_CASE("the bound of the normal stress by the energy is sharp")
{
  for (const unsigned int degree : {1, 2})
    {
      check_bound<2>(degree);
      check_bound<3>(degree);
    }
}



TEST_CASE("a uniform stress is found at the contact points, none in rigid motions")
{
  for (const char *unbiased : {"no", "yes"})
    {
      const TwoBlocks<2> scene(*make_method("Nitsche", {{"Unbiased", unbiased}}), 2);
      // u_y = -c y in bodies of plane strain with sigma_yy = -c E (1-nu)/((1+nu)(1-2nu)).
      LA::Vector u = scene.elasticity.zero_vector();
      VectorTools::interpolate(scene.mesh.mapping(),
                               scene.elasticity.dof_handler(),
                               DisplacementFunction<2>(VectorExpression<2>("0; -y"), 0),
                               u);
      const LA::Vector s     = scene.contact->stress(u)[0];
      const double     lower = 10 * 0.7 / (1.3 * 0.4), upper = 20 * 0.8 / (1.2 * 0.6);
      for (const auto i : s.locally_owned_elements())
        {
          CHECK(s(i) > 0.999999 * std::min(lower, upper));
          CHECK(s(i) < 1.000001 * std::max(lower, upper));
        }
      VectorTools::interpolate(scene.mesh.mapping(),
                               scene.elasticity.dof_handler(),
                               DisplacementFunction<2>(VectorExpression<2>("3-y; 2+x"), 0),
                               u);
      CHECK(scene.contact->stress(u)[0].linfty_norm() < 1e-11);
    }
}



TEST_CASE("a contact pressure exerts balanced forces")
{
  const TwoBlocks<3> scene(*make_method("Lagrange multiplier"), 1);
  LA::Vector         p = scene.contact->zero();
  for (const auto i : p.locally_owned_elements())
    p(i) = 1 + std::sin(i);
  p.compress(VectorOperation::insert);
  // All components of all forces together: action and reaction.
  CHECK(std::abs(scene.contact->total_force({p}, {scene.contact->zero()}).mean_value()) < 1e-14);
  // The gap does not change in rigid motions, so that the forces do no work: no moment either.
  for (const std::vector<double> &mode : rigid_body_modes(scene.elasticity))
    {
      LA::Vector u  = scene.elasticity.zero_vector();
      auto       at = mode.begin();
      for (const auto i : scene.elasticity.owned())
        u(i) = *at++;
      u.compress(VectorOperation::insert);
      LA::Vector change = scene.contact->gap(u);
      change -= scene.contact->initial_gap;
      CHECK(change.linfty_norm() < 1e-12);
    }
  // The points' areas sum up to the area of the slave, constant pressure to its resultant.
  CHECK(scene.contact->weight.l1_norm() == doctest::Approx(1));
}

namespace
{
  /// A block of large deformation at u + h du: what its stress vector is at a place of each
  /// boundary face, on which loads act.
  template <int dim>
  std::vector<BodyStress>
  stresses(const TestScene::SmallScene<dim> &scene,
           const LA::Vector                 &u,
           const LA::Vector                 &du,
           const double                      h)
  {
    LA::Vector moved = u;
    moved.add(h, du);
    const Configuration<dim> configuration(*scene.elasticity, moved);
    NormalStress<dim>        stress(configuration);
    Tensor<1, dim>           n;
    Point<dim - 1>           xi;
    std::vector<BodyStress>  result;
    for (unsigned int d = 0; d < dim; ++d)
      n[d] = 1 - 0.3 * d;
    for (unsigned int d = 0; d < dim - 1; ++d)
      xi[d] = 0.3 + 0.2 * d;
    SurfaceLoad<dim> load;
    load.pressure = 0.4;
    for (unsigned int d = 0; d < dim; ++d)
      load.traction[d] = 0.2 - 0.3 * d;
    for (const auto &cell : scene.elasticity->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const FacePatch<dim> patch(scene.mesh->mapping(), 1, cell, f);
              stress.reinit(cell);
              result.push_back(stress.at(unit_point<dim>(cell->reference_cell(), f, xi),
                                         stress_directions(n / n.norm(), true),
                                         patch.normal(xi),
                                         load));
            }
    return result;
  }

  template <int dim>
  void
  check_cauchy(const std::string &model, const unsigned int degree, const std::string &more)
  {
    CAPTURE(model);
    CAPTURE(degree);
    CAPTURE(more);
    const TestScene::SmallScene<dim> scene(
      {"Dimension=" + std::to_string(dim),
       "Model=" + model,
       "Deformation=finite",
       "Bodies/Names=block",
       "Bodies/block/Mesh=box",
       dim == 2 ? "Bodies/block/Corners=1,0 : 2,1.5" : "Bodies/block/Corners=1,0,0 : 2,1.5,1.2",
       dim == 2 ? "Bodies/block/Subdivisions=2,2" : "Bodies/block/Subdivisions=2,2,1",
       "Bodies/block/Young's modulus=3",
       "Bodies/block/Degree=" + std::to_string(degree),
       more});
    const LA::Vector       u = scene.rough_field(0.05, 1), du = scene.rough_field(1, 2);
    VolumetricStress<dim> &volumetric = scene.elasticity->volumetric_stress();
    LA::Vector             m          = volumetric.zero_vector();
    for (const auto i : m.locally_owned_elements())
      m(i) = 0.1 * std::sin(1. + i);
    m.compress(VectorOperation::insert);
    if (!volumetric.empty())
      volumetric.set_coefficients(m);
    constexpr double h      = 1e-5;
    const auto       before = stresses(scene, u, du, -h), after = stresses(scene, u, du, h);
    const auto       here = stresses(scene, u, du, 0.);
    const Values     at_u = everywhere(u), at_du = everywhere(du), at_m = everywhere(m);
    for (unsigned int i = 0; i < here.size(); ++i)
      {
        const double ratio = (after[i].ratio - before[i].ratio) / (2 * h);
        CHECK(at(here[i].ratio_row, at_du) == doctest::Approx(ratio).epsilon(1e-6));
        REQUIRE(here[i].components.size() == dim);
        for (unsigned int a = 0; a < dim; ++a)
          {
            const StressRow &one = here[i].components[a];
            const double     change =
              (after[i].components[a].value - before[i].components[a].value) / (2 * h);
            CHECK(at(one.displacement, at_du) == doctest::Approx(change).epsilon(1e-6));
            const double of_volumetric = volumetric.empty() ? 0. : at(one.volumetric, at_m);
            CHECK(one.offset + at(one.displacement, at_u) + of_volumetric ==
                  doctest::Approx(one.value).epsilon(1e-10));
          }
        CHECK(here[i].ratio_offset + at(here[i].ratio_row, at_u) ==
              doctest::Approx(here[i].ratio).epsilon(1e-10));
      }
  }
} // namespace

TEST_CASE("Cauchy's stress has the derivatives that its differences show")
{
  const std::string plain = "Bodies/block/Poisson's ratio=0.3",
                    mixed = "Bodies/block/Poisson's ratio=0.495";
  for (const std::string model : {"plane strain", "plane stress", "axisymmetric"})
    for (const unsigned int degree : {1, 2})
      check_cauchy<2>(model, degree, plain);
  for (const unsigned int degree : {1, 2})
    check_cauchy<3>("solid", degree, plain);
  check_cauchy<2>("axisymmetric", 2, mixed);
  check_cauchy<3>("solid", 2, mixed);
}
