// SPDX-License-Identifier: Apache-2.0
// Products without a matrix against the assembled matrix, on every kind of cell and constraint, and
// the level of degree one against its Galerkin product.

#include "linear_algebra/diagonal.h"
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"
#include "matrix_free/cell_stiffness.h"
#include "matrix_free/instruction_sets.h"
#include "multigrid/levels.h"
#include "solid/rigid_body_modes.h"
#include "solver/preconditioners/amg.h"

#include <doctest/doctest.h>

#include <cmath>

#include "contact_cases.h"
#include "stiffness_checks.h"

using namespace TestScene;

namespace
{
  std::vector<Case>
  cases()
  {
    std::vector<Case> result;
    for (const std::string degree : {"1", "2"})
      for (Case one : cases_3d())
        {
          one.name += ", degree " + degree;
          one.lines.push_back("Mesh/Degree=" + degree);
          result.push_back(one);
        }
    result.push_back({"degrees one and two",
                      cases_3d()[2].lines + Lines{"Mesh/Degree=2", "Bodies/lower/Degree=1"}});
    result.push_back({"tetrahedra", tetrahedra()});
    result.push_back({"distorted",
                      cases_3d()[0].lines +
                        Lines{"Mesh/Degree=2",
                              "Bodies/lower/Transformation=x+0.2*x*y+0.1*y*z; y+0.1*x*z; z+0.1*x*y",
                              "Contact pairs/pair/Master=lower.top"}});
    return result;
  }

  /// By many steps of a power iteration.
  double
  largest_eigenvalue(const LA::SparseMatrix &K, const LA::Vector &start)
  {
    LA::Vector inverse = LA::diagonal(K), x = start, y = start;
    LA::invert(inverse);
    double value = 0;
    for (unsigned int n = 0; n < 300; ++n)
      {
        K.vmult(y, x);
        y.scale(inverse);
        value = y.l2_norm() / x.l2_norm();
        x     = y;
        x /= y.l2_norm();
      }
    return value;
  }
} // namespace



TEST_CASE("products, diagonal and rows without a matrix are those of the matrix")
{
  for (const Case &one : cases())
    {
      CAPTURE(one.name);
      SmallScene<3>           scene(one.lines);
      const LA::SparseMatrix &K = scene.elasticity->stiffness();
      MatrixFreeStiffness     stiffness(*scene.elasticity);
      const LA::Vector        u     = scene.rough_field(1, 0.3);
      LA::Vector              exact = u, product = u;
      K.vmult(exact, u);
      stiffness.vmult(product, u);
      CHECK(distance(product, exact) < 1e-12);
      stiffness.vmult_add(product, u);
      product -= exact;
      CHECK(distance(product, exact) < 1e-12);
      CHECK(distance(times(stiffness.single_precision(), u), exact) < 1e-5);

      check_diagonal(*scene.elasticity, stiffness.diagonal(), LA::diagonal(K));

      LA::Vector marker = scene.elasticity->zero_vector();
      for (const auto i : marker.locally_owned_elements())
        marker(i) = i % 7 == 0 ? 1 : 0;
      marker.compress(VectorOperation::insert);
      check_rows(K, stiffness, marker);
      marker = 1.;
      check_rows(K, stiffness, marker);
    }
}



TEST_CASE("eigenvalues of cells bound those of K, and are large where cells are of bad shape")
{
  for (const Case &one : cases())
    {
      CAPTURE(one.name);
      SmallScene<3>       scene(one.lines);
      MatrixFreeStiffness stiffness(*scene.elasticity);
      const auto          sizes = stiffness.single_precision().row_l1_norms(),
                 diagonal       = stiffness.single_precision().diagonal();
      double largest            = 0;
      for (std::size_t i = 0; i < sizes.size(); ++i)
        largest = std::max<double>(largest, sizes[i] / diagonal[i]);
      largest = Utilities::MPI::max(largest, MPI_COMM_WORLD);
      const double known =
        largest_eigenvalue(scene.elasticity->stiffness(), scene.rough_field(1, 0.3));
      CHECK(largest > 0.9 * known);
      CHECK(largest < 3 * known);
    }
}



TEST_CASE("all instruction sets give the same")
{
  for (const unsigned int degree : {1u, 2u})
    {
      // Some cells are affine, others are not, and their number fills no batch.
      KernelCells        cells;
      const unsigned int n_nodes = (degree + 1) * (degree + 1) * (degree + 1), n_cells = 21;
      cells.degree = degree;
      for (unsigned int cell = 0; cell < n_cells; ++cell)
        {
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              const unsigned int n = degree + 1;
              const Point<3>     x(i % n, i / n % n + 0.2 * (i % n), i / (n * n));
              const double       bend = cell % 3 == 0 ? 0 : 0.1 * std::sin(cell + 3. * i);
              cells.points.insert(cells.points.end(), {x[0] + bend, x[1], (1 + 0.1 * cell) * x[2]});
              cells.nodes.push_back(3 * ((i * 5 + cell * 3) % (2 * n_nodes)));
            }
          cells.lambda.push_back(1 + 0.1 * cell);
          cells.mu.push_back(2 - 0.05 * cell);
        }
      std::vector<double> u(6 * n_nodes), first;
      for (unsigned int i = 0; i < u.size(); ++i)
        u[i] = std::sin(1 + 2. * i * i);
      std::vector<float> single_precision(u.begin(), u.end());
      single_precision.push_back(0); // may be read
      double size = 0;
      for (const std::string &set : instruction_sets())
        {
          CAPTURE(set);
          std::vector<double> f(u.size(), 0.);
          CellKernel<double>::create(cells, set)->add_product(f.data(), u.data());
          std::vector<float> g(u.size(), 0.f);
          CellKernel<float>::create(cells, set)->add_product(g.data(), single_precision.data());
          if (first.empty())
            first = f;
          for (const double value : first)
            size = std::max(size, std::abs(value));
          double worst = 0, worst_rounded = 0;
          for (unsigned int i = 0; i < f.size(); ++i)
            {
              worst         = std::max(worst, std::abs(f[i] - first[i]));
              worst_rounded = std::max(worst_rounded, std::abs(g[i] - first[i]));
            }
          CHECK(size > 1);
          CHECK(worst < 1e-13 * size);
          CHECK(worst_rounded < 1e-5 * size);
        }
    }
}



namespace
{
  /// Each level against the product of the one above it with the prolongation from there.
  void
  check_levels(const Lines &lines, const bool to_coarser_meshes, const unsigned int least)
  {
    SmallScene<3>             scene(lines);
    const MatrixFreeStiffness stiffness(*scene.elasticity);
    const Spaces              spaces = make_spaces(*scene.elasticity, stiffness, to_coarser_meshes);
    REQUIRE(spaces.levels.size() >= least);
    REQUIRE(spaces.levels.back().matrix);
    const StiffnessOperator<float> *above = &stiffness.single_precision();
    for (const Level &level : spaces.levels)
      {
        CHECK(galerkin_defect(*above, level) < 1e-5);
        above = level.stiffness.get();
      }
    CHECK(spaces.nodes.coordinates.size() == above->owned().n_elements());
  }
} // namespace



TEST_CASE("levels are Galerkin products where cells are flat, on meshes with hanging nodes, too")
{
  for (const Case &one : cases_3d())
    if (one.name != "curved, not matching")
      {
        CAPTURE(one.name);
        check_levels(one.lines + Lines{"Mesh/Degree=2"}, false, 1);
        check_levels(one.lines + Lines{"Mesh/Degree=1", "Mesh/Refinements=2"}, true, 1);
        if (one.name == "hanging nodes")
          check_levels(one.lines + Lines{"Mesh/Degree=2", "Mesh/Refinements=2"}, true, 2);
      }
  check_levels(tetrahedra(), false, 1);
}



TEST_CASE("prolongation from coarser meshes keeps rigid-body motions")
{
  // No support: they are to pass all levels.
  SmallScene<3>             scene({"Dimension=3",
                                   "Mesh/Degree=1",
                                   "Mesh/Refinements=3",
                                   "Bodies/Names=bar",
                                   "Bodies/bar/Corners=0,0,0 : 2,3,4",
                                   "Bodies/bar/Subdivisions=1,2,2",
                                   "Bodies/bar/Young's modulus=1",
                                   "Bodies/bar/Poisson's ratio=0.3",
                                   "Mesh/Refinement regions/Names=near",
                                   "Mesh/Refinement regions/near/Inside=min(0.5 - x, 1 - y)",
                                   "Newton/Unconstrained modes=stabilise"});
  const MatrixFreeStiffness stiffness(*scene.elasticity);
  const Spaces              spaces = make_spaces(*scene.elasticity, stiffness, true);
  REQUIRE(spaces.levels.size() >= 2);
  const auto exact = rigid_body_modes(*scene.elasticity),
             modes = rigid_body_modes(spaces.nodes, scene.elasticity->mesh().extent());
  for (unsigned int m = 0; m < 6; ++m)
    {
      LA::Vector u(spaces.levels.back().stiffness->owned(), MPI_COMM_WORLD);
      std::copy(modes[m].begin(), modes[m].end(), LA::values_of(u));
      for (auto level = spaces.levels.rbegin(); level != spaces.levels.rend(); ++level)
        {
          const bool is_first = level + 1 == spaces.levels.rend();
          u                   = times(*level->prolongation,
                    u,
                    is_first ? stiffness.owned() : (level + 1)->stiffness->owned());
        }
      double worst = 0;
      for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
        if (const auto dof = u.locally_owned_elements().nth_index_in_set(i);
            !scene.elasticity->constraints().is_constrained(dof))
          worst = std::max(worst, std::abs(LA::values_of(u)[i] - exact[m][i]));
      CHECK(Utilities::MPI::max(worst, MPI_COMM_WORLD) < 1e-6); // single precision
    }
}



TEST_CASE("supports at nodes that degree one has not are not lost")
{
  // The middles of edges of a bar's cells, so that no vertex is held.
  SmallScene<3>             scene({"Dimension=3",
                                   "Mesh/Degree=2",
                                   "Bodies/Names=bar",
                                   "Bodies/bar/Corners=0,0,0 : 2,3,4",
                                   "Bodies/bar/Subdivisions=2,2,2",
                                   "Bodies/bar/Young's modulus=1",
                                   "Bodies/bar/Poisson's ratio=0.3",
                                   "Supports/Names=one, two, three",
                                   "Supports/one/Point=0.5,0,0",
                                   "Supports/one/Displacement=0; 0; 0",
                                   "Supports/two/Point=1.5,0,0",
                                   "Supports/two/Displacement=free; 0; 0",
                                   "Supports/three/Point=0.5,3,0",
                                   "Supports/three/Displacement=free; free; 0"});
  const MatrixFreeStiffness stiffness(*scene.elasticity);
  const Spaces              spaces = make_spaces(*scene.elasticity, stiffness, true);
  REQUIRE(spaces.levels.size() == 1);
  const LA::SparseMatrix &K     = *spaces.levels.front().matrix;
  const auto              modes = rigid_body_modes(spaces.nodes, scene.elasticity->mesh().extent());
  const unsigned int      n     = modes.size();
  FullMatrix<double>      energies(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        LA::Vector a(K.locally_owned_range_indices(), MPI_COMM_WORLD), b = a, Kb = a;
        std::copy(modes[i].begin(), modes[i].end(), LA::values_of(a));
        std::copy(modes[j].begin(), modes[j].end(), LA::values_of(b));
        K.vmult(Kb, b);
        energies(i, j) = a * Kb;
      }
  // None is free: the smallest eigenvalue, by the inverse's trace.
  const double size = energies.frobenius_norm();
  energies.gauss_jordan();
  CHECK(energies.trace() * size < 1e4);
  CHECK(energies.trace() > 0);
}



namespace
{
  void
  check_cycle(const Lines &lines)
  {
    SmallScene<3> scene(lines);
    scene.use({"Method=penalty"});
    const AssembledStiffness  matrix(scene.elasticity->stiffness());
    const MatrixFreeStiffness cells(*scene.elasticity);
    for (const Stiffness *stiffness : std::vector<const Stiffness *>{&matrix, &cells})
      {
        Spaces          spaces = make_spaces(*scene.elasticity, *stiffness, true);
        const Hierarchy hierarchy(*stiffness,
                                  std::move(spaces.levels),
                                  rigid_body_modes(spaces.nodes, scene.elasticity->mesh().extent()),
                                  3);
        AMG             amg(hierarchy, &scene.gap_operator());
        LA::Vector      springs = scene.gap_operator().weight;
        springs *= 100;
        amg.set_contact_stiffness({springs});
        const LA::Vector x = scene.rough_field(1, 0.3), y = scene.rough_field(1, 1.1);
        LA::Vector       Vx = x, Vy = y;
        amg.vmult(Vx, x);
        amg.vmult(Vy, y);
        const double size = std::sqrt((x * Vx) * (y * Vy));
        CHECK(std::abs(x * Vy - y * Vx) < 1e-5 * size);
        CHECK(x * Vx > 0);
      }
  }
} // namespace



TEST_CASE("a cycle through spaces is symmetric and positive definite, matrix or not")
{
  for (const Case &one : cases_3d())
    {
      CAPTURE(one.name);
      check_cycle(one.lines + Lines{"Mesh/Degree=2"});
      if (one.name == "hanging nodes")
        check_cycle(one.lines + Lines{"Mesh/Degree=1", "Mesh/Refinements=2"});
    }
}
