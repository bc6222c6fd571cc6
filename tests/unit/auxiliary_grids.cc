// SPDX-License-Identifier: Apache-2.0
// The grids below a mesh of one level: what they interpolate exactly, their matrices, what they
// keep apart, and how fast cycles with them converge.

#include "multigrid/auxiliary_grids.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/row_view.h"
#include "matrix_free/cell_stiffness.h"
#include "multigrid/levels.h"
#include "solid/rigid_body_modes.h"
#include "solver/preconditioners/amg.h"

#include <deal.II/lac/solver_cg.h>

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "stiffness_checks.h"

using namespace TestScene;

namespace
{
  const Lines turned_bar = {"Dimension=3",
                            "Bodies/Names=bar",
                            "Bodies/bar/Corners=0,0,0 : 2,3,4",
                            "Bodies/bar/Subdivisions=7,11,13",
                            "Bodies/bar/Transformation=x-y+0.2*y*z; x+y+0.1*x*z; z+0.3*x*y",
                            "Bodies/bar/Young's modulus=1",
                            "Bodies/bar/Poisson's ratio=0.3"};

  struct OfCells
  {
    std::string name;
    Lines       lines;
  };

  const std::vector<OfCells> kinds = {
    {"hexahedra", {"Mesh/Degree=1"}},
    {"hexahedra, degree two", {"Mesh/Degree=2", "Bodies/bar/Subdivisions=7,9,9"}},
    {"closer nodes",
     {"Mesh/Degree=1",
      "Bodies/bar/Subdivisions=17,12,12",
      "Bodies/bar/Transformation=x+x*x; y; z+0.5*x"}},
    {"flat cells", {"Mesh/Degree=1", "Bodies/bar/Subdivisions=7,7,50"}}};

  void
  check_motions(const Lines &lines)
  {
    SmallScene<3>             scene(lines);
    const MatrixFreeStiffness stiffness(*scene.elasticity);
    const Spaces              spaces = make_spaces(*scene.elasticity, stiffness, true);
    REQUIRE(!spaces.levels.empty());
    CHECK(spaces.levels.back().matrix->m() < stiffness.size() / 3);
    const auto box   = scene.elasticity->mesh().extent();
    const auto exact = rigid_body_modes(*scene.elasticity),
               modes = rigid_body_modes(spaces.nodes, box);
    for (unsigned int m = 0; m < modes.size(); ++m)
      {
        LA::Vector u(spaces.levels.back().stiffness->owned(), MPI_COMM_WORLD);
        REQUIRE(modes[m].size() == u.locally_owned_size());
        std::copy(modes[m].begin(), modes[m].end(), LA::values_of(u));
        for (unsigned int l = spaces.levels.size(); l-- > 0;)
          u = times(*spaces.levels[l].prolongation,
                    u,
                    l == 0 ? stiffness.owned() : spaces.levels[l - 1].stiffness->owned());
        double worst = 0;
        for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
          worst = std::max(worst, std::abs(LA::values_of(u)[i] - exact[m][i]));
        CHECK(Utilities::MPI::max(worst, MPI_COMM_WORLD) < 1e-5); // single precision
      }
  }

  void
  check_products(const Lines &lines)
  {
    SmallScene<3>                   scene(lines);
    const MatrixFreeStiffness       stiffness(*scene.elasticity);
    const Spaces                    spaces = make_spaces(*scene.elasticity, stiffness, true);
    const StiffnessOperator<float> *above  = &stiffness.single_precision();
    for (const Level &level : spaces.levels)
      {
        // The space of degree one has its own discretisation.
        if (scene.elasticity->degree() == 1 || &level != &spaces.levels.front())
          CHECK(galerkin_defect(*above, level) < 1e-5);
        above = level.stiffness.get();
      }
  }

  /// Iterations of CG to eight digits with the cycle of a body that is held.
  unsigned int
  iterations(const Lines &lines, const bool with_matrix)
  {
    SmallScene<3>             scene(lines);
    const LA::SparseMatrix   &K = scene.elasticity->stiffness();
    const AssembledStiffness  matrix(K);
    const MatrixFreeStiffness cells(*scene.elasticity);
    const Stiffness &stiffness = with_matrix ? static_cast<const Stiffness &>(matrix) : cells;
    Spaces           spaces    = make_spaces(*scene.elasticity, stiffness, true);
    const Hierarchy  hierarchy(stiffness,
                              std::move(spaces.levels),
                              rigid_body_modes(spaces.nodes, scene.elasticity->mesh().extent()),
                              3);
    const AMG        amg(hierarchy, nullptr);
    const LA::Vector f = scene.rough_field(1, 0.7);
    LA::Vector       u = scene.elasticity->zero_vector();
    SolverControl    control(200, 1e-8 * f.l2_norm());
    SolverCG<LA::Vector>(control).solve(K, u, f, amg);
    return control.last_step();
  }

  const Lines held_and_fixed = {"Supports/Names=base",
                                "Supports/base/Boundaries=bar.bottom",
                                "Supports/base/Displacement=0; 0; 0"};
} // namespace



TEST_CASE("grids interpolate rigid-body motions exactly")
{
  for (const OfCells &kind : kinds)
    {
      CAPTURE(kind.name);
      check_motions(turned_bar + kind.lines + Lines{"Newton/Unconstrained modes=stabilise"});
    }
}



TEST_CASE("matrices of grids are Galerkin products, with supports, too")
{
  for (const OfCells &kind : kinds)
    {
      CAPTURE(kind.name);
      check_products(turned_bar + kind.lines + held_and_fixed);
      check_products(turned_bar + kind.lines +
                     Lines{"Supports/Names=base",
                           "Supports/base/Boundaries=bar.bottom",
                           "Supports/base/Type=roller"});
    }
}



TEST_CASE("the products of cells and of the assembled matrix make the same grids")
{
  SmallScene<3>       scene(turned_bar + Lines{"Mesh/Degree=1",
                                         "Supports/Names=base",
                                         "Supports/base/Boundaries=bar.bottom",
                                         "Supports/base/Type=roller"});
  const NodePositions nodes     = node_positions(*scene.elasticity);
  const Spaces        of_matrix = auxiliary_grids(scene.elasticity->stiffness(), nodes),
               of_cells         = auxiliary_grids(cell_space(*scene.elasticity), nodes);
  REQUIRE(!of_matrix.levels.empty());
  REQUIRE(of_matrix.levels.size() == of_cells.levels.size());
  const LA::SparseMatrix &one = *of_matrix.levels.front().matrix,
                         &two = *of_cells.levels.front().matrix;
  // On several ranks the distances of nodes that two of them share may differ, and with them the
  // grids.
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    {
      REQUIRE(one.m() == two.m());
      double worst = 0;
      for (unsigned int i = 0; i < one.m(); ++i)
        {
          const LA::RowView row(one, i);
          for (int k = 0; k < row.size; ++k)
            worst = std::max(worst, std::abs(row.values[k] - two.el(i, row.columns[k])));
        }
      CHECK(worst < 1e-12 * one.linfty_norm());
    }
}



// A square lattice of n x n nodes, cut between two columns except for the uppermost rows: nodes on
// both sides of the cut have nearly the same place, but no unknown in common.
TEST_CASE("grids do not connect the sides of a slit")
{
  const unsigned int n = 40, cut = 20, uncut_rows = 10;
  const IndexSet     nodes =
    LA::contiguous_partition(n * n / Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) +
                               (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 ?
                                  n * n % Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) :
                                  0),
                             MPI_COMM_WORLD);
  IndexSet owned(2 * n * n);
  for (const auto node : nodes)
    owned.add_range(2 * node, 2 * node + 2);
  std::vector<std::vector<std::pair<types::global_dof_index, double>>> rows;
  NodePositions                                                        positions;
  positions.dim = 2;
  for (const auto node : nodes)
    {
      const int i = node % n, j = node / n;
      positions.coordinates.push_back(i < int(cut) ? i : i - 0.99);
      positions.coordinates.push_back(j);
      for (unsigned int c = 0; c < 2; ++c)
        {
          rows.emplace_back();
          for (int a = std::max(0, i - 1); a <= std::min<int>(n - 1, i + 1); ++a)
            for (int b = std::max(0, j - 1); b <= std::min<int>(n - 1, j + 1); ++b)
              if ((a < int(cut)) == (i < int(cut)) || std::min(b, j) >= int(n - uncut_rows))
                rows.back().emplace_back(2 * (b * n + a) + c, a == i && b == j ? 8.1 : -1.);
          // Components are coupled too.
          rows.back().emplace_back(2 * node + 1 - c, 0.1);
        }
    }
  const LA::SparseMatrix K      = LA::matrix_of(rows, owned, owned, MPI_COMM_WORLD);
  const Spaces           spaces = auxiliary_grids(K, positions);
  REQUIRE(!spaces.levels.empty());

  // The coarse unknowns of two nodes: of the left and right side of the cut.
  const auto common = [&](const unsigned int j) {
    std::vector<std::vector<std::pair<types::global_dof_index, double>>> selected;
    const bool is_first = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (is_first)
      selected = {{{2 * (j * n + cut - 1), 1.}}, {{2 * (j * n + cut), 1.}}};
    const LA::SparseMatrix B = LA::matrix_of(
      selected, LA::contiguous_partition(is_first ? 2 : 0, MPI_COMM_WORLD), owned, MPI_COMM_WORLD);
    const LA::SparseMatrix BP      = spaces.levels.front().prolongation->times(B);
    const auto             columns = LA::global_columns(BP);
    bool                   any     = false;
    if (is_first)
      {
        const LA::RowView                 left(BP, 0), right(BP, 1);
        std::set<types::global_dof_index> of_left;
        for (int k = 0; k < left.size; ++k)
          of_left.insert(columns[left.columns[k]]);
        for (int k = 0; k < right.size; ++k)
          any = any || of_left.count(columns[right.columns[k]]) > 0;
        CHECK(left.size > 0);
        CHECK(right.size > 0);
      }
    return Utilities::MPI::max(any ? 1 : 0, MPI_COMM_WORLD) == 1;
  };
  CHECK(!common(5));
  CHECK(!common(n - uncut_rows - 5));
  CHECK(common(n - 2));
}



TEST_CASE("cycles with grids converge fast, also for bodies that no grid fits")
{
  const Lines held = turned_bar + held_and_fixed;
  for (const bool with_matrix : {false, true})
    {
      CAPTURE(with_matrix);
      CHECK(iterations(held + Lines{"Mesh/Degree=1", "Bodies/bar/Transformation=x; y; z"},
                       with_matrix) <= 9);
      CHECK(iterations(held + Lines{"Mesh/Degree=1"}, with_matrix) <= 16);
      CHECK(iterations(held + Lines{"Mesh/Degree=1", "Bodies/bar/Subdivisions=16,22,29"},
                       with_matrix) <= 16);
    }
}



TEST_CASE("there are no grids where all vertices are supported")
{
  SmallScene<3>             scene(turned_bar + Lines{"Bodies/bar/Transformation=x; y; z",
                                         "Bodies/bar/Subdivisions=19,19,1",
                                         "Mesh/Degree=2",
                                         "Supports/Names=base",
                                         "Supports/base/Boundaries=bar.bottom, bar.top",
                                         "Supports/base/Displacement=0; 0; 0"});
  const MatrixFreeStiffness stiffness(*scene.elasticity);
  const Spaces              spaces = make_spaces(*scene.elasticity, stiffness, true);
  REQUIRE(spaces.levels.size() == 1);
  CHECK(spaces.levels.front().matrix->m() == 3 * 20 * 20 * 2);
}
