// SPDX-License-Identifier: Apache-2.0
// Tangents of large deformation without a matrix, by the points of integration, their means over
// cells, and those of coarser meshes.

#include "matrix_free/instruction_sets.h"
#include "matrix_free/tangent_stiffness.h"
#include "multigrid/levels.h"
#include "solid/rigid_body_modes.h"
#include "solver/nonlinear_solid.h"

#include <doctest/doctest.h>

#include <cmath>

#include "contact_cases.h"
#include "stiffness_checks.h"

using namespace TestScene;

namespace
{
  /// Without pressures, whose tangents are assembled.
  std::vector<Case>
  cases()
  {
    std::vector<Case> result;
    for (const std::string degree : {"1", "2"})
      for (const Case &one : cases_3d())
        {
          result.push_back({one.name + ", degree " + degree,
                            Lines{"Deformation=finite", "Mesh/Degree=" + degree}});
          for (const std::string &line : one.lines)
            if (line.rfind("Loads", 0) != 0)
              result.back().lines.push_back(line);
        }
    result.push_back({"degrees one and two, two laws",
                      cases_3d()[2].lines + Lines{"Deformation=finite",
                                                  "Mesh/Degree=2",
                                                  "Bodies/lower/Degree=1",
                                                  "Bodies/upper/Law=Hencky"}});
    return result;
  }

  class Tangent
  {
  public:
    Tangent(const StiffnessForm form, SmallScene<3> &scene, const LA::Vector &u)
      : bodies(form, *scene.elasticity, bodies_of_dofs(*scene.elasticity), scene.timer)
    {
      bodies.linearise(u);
    }

    const Stiffness &
    stiffness() const
    {
      return bodies.stiffness();
    }

    NonlinearSolid<3> bodies;
  };
} // namespace



TEST_CASE("products, diagonal and rows of tangents without a matrix are those of the matrix")
{
  for (const Case &one : cases())
    {
      CAPTURE(one.name);
      constexpr double rounding = 1e-6; // of tangents, in single precision
      SmallScene<3>    scene(one.lines);
      LA::Vector       u = scene.rough_field(0.02, 0.3), v = scene.rough_field(1, 0.7);
      Tangent          matrix(StiffnessForm::assembled, scene, u),
        cells(StiffnessForm::matrix_free, scene, scene.elasticity->zero_vector());
      const unsigned int version = cells.stiffness().version();
      cells.stiffness().matrix(); // of another place
      cells.bodies.linearise(u);
      CHECK(cells.stiffness().version() != version);

      LA::Vector exact = v, product = v;
      matrix.stiffness().vmult(exact, v);
      cells.stiffness().vmult(product, v);
      CHECK(distance(product, exact) < rounding);
      // Means over cells are another operator, which is as large.
      const LA::Vector mean = times(cells.stiffness().single_precision(), v);
      CHECK(v * mean > 0.5 * (v * exact));
      CHECK(v * mean < 2 * (v * exact));

      const LA::SparseMatrix &K = matrix.stiffness().matrix();
      check_diagonal(*scene.elasticity, cells.stiffness().diagonal(), LA::diagonal(K), rounding);
      LA::Vector marker = scene.elasticity->zero_vector();
      for (const auto i : marker.locally_owned_elements())
        marker(i) = i % 7 == 0 ? 1 : 0;
      marker.compress(VectorOperation::insert);
      check_rows(K, cells.stiffness(), marker);
      marker = 1.;
      check_rows(K, cells.stiffness(), marker);
    }
}



namespace
{
  /// Where gradients do not change in a cell, its tangent does not either.
  void
  check_levels(const Lines &lines, const unsigned int least)
  {
    SmallScene<3>    scene(lines);
    const LA::Vector u = interpolant(scene, [](const Point<3> &x, const unsigned int body) {
      const double stretch = 0.1 + 0.1 * body;
      return Tensor<1, 3>({stretch * x[0], 0.1 * x[0] - 0.2 * x[2], stretch * x[1]});
    });
    // Supports have another displacement: it is not told of them here.
    DeformationKernel<3> kernel(*scene.mesh,
                                scene.elasticity->finite_elements(),
                                scene.elasticity->model());
    TangentStiffness     stiffness(*scene.elasticity, kernel);
    REQUIRE(stiffness.evaluate(scene.elasticity->with_ghosts(u)) == "");
    stiffness.update();
    const LA::Vector v     = scene.rough_field(1, 0.7);
    LA::Vector       exact = v;
    stiffness.vmult(exact, v);
    CHECK(distance(times(stiffness.single_precision(), v), exact) < 1e-5);

    const Spaces spaces = make_spaces(*scene.elasticity, stiffness, true);
    REQUIRE(spaces.levels.size() >= least);
    REQUIRE(spaces.levels.back().matrix);
    const StiffnessOperator<float> *above = &stiffness.single_precision();
    for (const Level &level : spaces.levels)
      {
        CHECK(galerkin_defect(*above, level) < 1e-5);
        above = level.stiffness.get();
      }
  }
} // namespace



TEST_CASE("levels of tangents are Galerkin products where gradients are uniform")
{
  for (const Case &one : cases_3d())
    if (one.name == "hanging nodes" || one.name == "flat, matching")
      {
        CAPTURE(one.name);
        const Lines lines = one.lines + Lines{"Deformation=finite"};
        check_levels(lines + Lines{"Mesh/Degree=2"}, 1);
        check_levels(lines + Lines{"Mesh/Degree=1", "Mesh/Refinements=2"}, 1);
        if (one.name == "hanging nodes")
          check_levels(lines + Lines{"Mesh/Degree=2", "Mesh/Refinements=2"}, 2);
      }
  check_levels(tetrahedra() + Lines{"Deformation=finite"}, 1);
}



TEST_CASE("all instruction sets give the same products of tangents")
{
  for (const unsigned int degree : {1u, 2u})
    for (const bool one_a_cell : {true, false})
      {
        KernelCells        cells;
        const unsigned int n_nodes = (degree + 1) * (degree + 1) * (degree + 1), n_cells = 21;
        cells.degree = degree;
        for (unsigned int cell = 0; cell < n_cells; ++cell)
          for (unsigned int i = 0; i < n_nodes; ++i)
            cells.nodes.push_back(3 * ((i * 5 + cell * 3) % (2 * n_nodes)));
        cells.tangents.resize(one_a_cell ? n_cells : n_cells * n_nodes);
        for (unsigned int k = 0; k < cells.tangents.size(); ++k)
          for (unsigned int m = 0; m < n_tangent_numbers; ++m)
            cells.tangents[k][m] = std::sin(3. * k + 5. * m);
        std::vector<double> u(6 * n_nodes), first;
        for (unsigned int i = 0; i < u.size(); ++i)
          u[i] = std::sin(1 + 2. * i * i);
        std::vector<float> single_precision(u.begin(), u.end());
        single_precision.push_back(0); // may be read
        for (const std::string &set : instruction_sets())
          {
            CAPTURE(set);
            std::vector<double> f(u.size(), 0.);
            CellKernel<double>::create(cells, set)->add_product(f.data(), u.data());
            std::vector<float> g(u.size(), 0.f);
            CellKernel<float>::create(cells, set)->add_product(g.data(), single_precision.data());
            if (first.empty())
              first = f;
            double size = 0, worst = 0, worst_rounded = 0;
            for (unsigned int i = 0; i < f.size(); ++i)
              {
                size          = std::max(size, std::abs(first[i]));
                worst         = std::max(worst, std::abs(f[i] - first[i]));
                worst_rounded = std::max(worst_rounded, std::abs(g[i] - first[i]));
              }
            CHECK(size > 1);
            CHECK(worst < 1e-13 * size);
            CHECK(worst_rounded < 1e-5 * size);
          }
      }
}
