// SPDX-License-Identifier: Apache-2.0
// How fast kernels multiply, in each instruction set of this processor, beside what its memory
// bears, the assembled matrix, and the class MatrixFree of deal.II.
//
//   products [refinements of a cube, 5] [seconds for each number, 0.5]
//
// One process. Affine cells are a cube's; general ones are the same with their vertices moved; then
// tangents, one a cell and one a point. A row in which the set is "matrix" is the product with the
// assembled matrix, one with "deal.II" that of MatrixFree, whose instruction set is the one deal.II
// was compiled for.

#include "linear_algebra/values.h"
#include "matrix_free/cell_kernel.h"
#include "matrix_free/cell_space.h"
#include "matrix_free/instruction_sets.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>

using namespace dealii;
using namespace Signorini;

namespace
{
  constexpr int dim = 3;

  /// A cube of hexahedra, refined that often, or of tetrahedra with about as many nodes.
  class Cube
  {
  public:
    Cube(const unsigned int degree,
         const unsigned int refinements,
         const bool         of_tetrahedra,
         const bool         affine)
      : of_tetrahedra(of_tetrahedra)
      , affine(affine)
      , degree(degree)
      , dofs(triangulation)
    {
      if (of_tetrahedra)
        GridGenerator::subdivided_hyper_cube_with_simplices(triangulation, 1u << refinements);
      else
        {
          GridGenerator::hyper_cube(triangulation);
          triangulation.refine_global(refinements);
        }
      if (!affine && !of_tetrahedra)
        GridTools::transform(
          [](const Point<dim> &x) {
            return x + 0.1 * Point<dim>(x[1] * x[2], x[0] * x[2], x[0] * x[1]);
          },
          triangulation);
      if (of_tetrahedra)
        dofs.distribute_dofs(FESystem<dim>(FE_SimplexP<dim>(degree), dim));
      else
        dofs.distribute_dofs(FESystem<dim>(FE_Q<dim>(degree), dim));
    }

    /// Numbered as the program does.
    KernelCells
    cells() const
    {
      const auto               &element = dofs.get_fe(), &scalar = element.base_element(0);
      std::vector<unsigned int> nodes(scalar.n_dofs_per_cell());
      std::iota(nodes.begin(), nodes.end(), 0);
      if (const auto *fe = dynamic_cast<const FE_Q<dim> *>(&scalar))
        nodes = fe->get_poly_space_numbering_inverse();
      std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
      KernelCells                          result;
      result.degree         = degree;
      result.are_tetrahedra = of_tetrahedra;
      for (const auto &cell : dofs.active_cell_iterators())
        {
          cell->get_dof_indices(indices);
          for (const unsigned int node : nodes)
            {
              result.nodes.push_back(indices[element.component_to_system_index(0, node)]);
              // Multilinear in the vertices, as the mapping is.
              Point<dim> x;
              for (const unsigned int v : cell->vertex_indices())
                x +=
                  element.reference_cell().d_linear_shape_function(scalar.unit_support_point(node),
                                                                   v) *
                  cell->vertex(v);
              // Edges of curved tetrahedra.
              if (of_tetrahedra && !affine && node >= dim + 1)
                x[0] += 0.02 * cell->diameter() * std::sin(10 * x[1]);
              result.points.insert(result.points.end(), x.begin_raw(), x.end_raw());
            }
          result.lambda.push_back(1);
          result.mu.push_back(1);
        }
      return result;
    }

    const bool         of_tetrahedra, affine;
    const unsigned int degree;
    Triangulation<dim> triangulation;
    DoFHandler<dim>    dofs;
  };

  void
  print(const Cube  &cube,
        const char  *precision,
        const char  *shape,
        const char  *set,
        const double time,
        const double bytes)
  {
    const double n = cube.dofs.n_dofs();
    std::printf("%-11s %6u  %-9s  %-8s  %-8s  %10.0f  %8.0f  %9.0f  %6.1f\n",
                cube.of_tetrahedra ? "tetrahedra" : "hexahedra",
                cube.degree,
                precision,
                shape,
                set,
                n,
                n / time / 1e6,
                bytes / n,
                bytes / time / 1e9);
    std::fflush(stdout);
  }

  /// Of one call, the quickest of many.
  double
  seconds(const double time, const std::function<void()> &act)
  {
    using Clock      = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto since = [](const auto &t) {
      return std::chrono::duration<double>(Clock::now() - t).count();
    };
    double result = 1e9;
    act();
    while (since(start) < time)
      {
        const auto before = Clock::now();
        act();
        result = std::min(result, since(before));
      }
    return result;
  }

  template <typename Number>
  void
  measure(const Cube        &cube,
          const KernelCells &cells,
          const char        *precision,
          const char        *shape,
          const std::string &set,
          const double       time)
  {
    const auto        kernel = CellKernel<Number>::create(cells, set);
    const std::size_t n      = cube.dofs.n_dofs();
    // A kernel may read one element behind the last one.
    std::vector<Number> u(n + 1, 1), f(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
      u[i] = Number(i % 7) - 3;
    print(cube,
          precision,
          shape,
          set.c_str(),
          seconds(time, [&] { kernel->add_product(f.data(), u.data()); }),
          kernel->memory_consumption() + 3. * n * sizeof(Number));
  }

  /// Of the assembled matrix.
  void
  measure_matrix(const Cube &cube, KernelCells cells, const char *shape, const double time)
  {
    const IndexSet all = complete_index_set(cube.dofs.n_dofs());
    CellSpace space{all, {std::move(cells)}, {}, LA::Vector(all, MPI_COMM_SELF), MPI_COMM_SELF};
    space.constraints.close();
    LA::SparseMatrix K;
    assemble(space, K);
    LA::Vector u(all, MPI_COMM_SELF), f(all, MPI_COMM_SELF);
    u = 1.;
    print(cube,
          "double",
          shape,
          "matrix",
          seconds(time, [&] { K.vmult(f, u); }),
          12. * K.n_nonzero_elements() + 16. * all.size());
  }

  /// Of the class of deal.II. @tparam degree -1 for tetrahedra, of any degree
  template <int degree, typename Number>
  void
  measure_deal_ii(const Cube &cube, const char *precision, const char *shape, const double time)
  {
    using Field = LinearAlgebra::distributed::Vector<Number>;
    MatrixFree<dim, Number>   data;
    AffineConstraints<Number> constraints;
    constraints.close();
    typename MatrixFree<dim, Number>::AdditionalData settings;
    settings.tasks_parallel_scheme = MatrixFree<dim, Number>::AdditionalData::none;
    if constexpr (degree < 0)
      data.reinit(MappingFE<dim>(FE_SimplexP<dim>(1)),
                  cube.dofs,
                  constraints,
                  QGaussSimplex<dim>(cube.degree),
                  settings);
    else
      data.reinit(MappingQ<dim>(1), cube.dofs, constraints, QGauss<1>(degree + 1), settings);
    Field u, f;
    data.initialize_dof_vector(u);
    data.initialize_dof_vector(f);
    u                  = Number(1);
    const auto product = [](const auto &of, Field &dst, const Field &src, const auto &range) {
      FEEvaluation<dim, degree, degree + 1, dim, Number> at(of, range);
      for (unsigned int cell = range.first; cell < range.second; ++cell)
        {
          at.reinit(cell);
          at.gather_evaluate(src, EvaluationFlags::gradients);
          for (const unsigned int q : at.quadrature_point_indices())
            {
              auto       stress   = Number(2) * at.get_symmetric_gradient(q);
              const auto pressure = trace(stress) * Number(0.5);
              for (unsigned int c = 0; c < dim; ++c)
                stress[c][c] += pressure;
              at.submit_symmetric_gradient(stress, q);
            }
          at.integrate_scatter(EvaluationFlags::gradients, dst);
        }
    };
    const std::function<void(const MatrixFree<dim, Number> &,
                             Field &,
                             const Field &,
                             const std::pair<unsigned int, unsigned int> &)>
      act = product;
    print(cube,
          precision,
          shape,
          "deal.II",
          seconds(time, [&] { data.cell_loop(act, f, u, true); }),
          data.memory_consumption() + 3. * u.size() * sizeof(Number));
  }

  void
  measure_memory(const double time)
  {
    const std::size_t   n = 1 << 25;
    std::vector<double> a(n, 0), b(n, 1), c(n, 2);
    const double        t = seconds(time, [&] {
      for (std::size_t i = 0; i < n; ++i)
        a[i] = b[i] + 3 * c[i];
    });
    std::printf("memory: a = b + 3 c on vectors of %zu MB: %.1f GB/s\n\n",
                n * sizeof(double) / 1000000,
                4 * n * sizeof(double) / t / 1e9);
  }
} // namespace



int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int                     refinements = argc > 1 ? std::atoi(argv[1]) : 5;
  const double                           time        = argc > 2 ? std::atof(argv[2]) : 0.5;
  measure_memory(time);
  std::printf(
    "cells       degree  precision  shape     set             dofs   Mdofs/s  bytes/dof    GB/s\n");
  for (const bool of_tetrahedra : {false, true})
    for (const unsigned int degree : {1u, 2u})
      {
        for (const bool affine : {true, false})
          {
            // Tetrahedra of degree 1 are always affine.
            if (of_tetrahedra && degree == 1 && !affine)
              continue;
            const Cube        cube(degree, refinements + (degree == 1), of_tetrahedra, affine);
            const char *const shape = affine ? "affine" : "general";
            const KernelCells cells = cube.cells();
            for (const std::string &set : instruction_sets())
              {
                measure<double>(cube, cells, "double", shape, set, time);
                measure<float>(cube, cells, "float", shape, set, time);
              }
            if (of_tetrahedra && affine)
              {
                measure_deal_ii<-1, double>(cube, "double", shape, time);
                measure_deal_ii<-1, float>(cube, "float", shape, time);
              }
            else if (!of_tetrahedra && degree == 1)
              {
                measure_deal_ii<1, double>(cube, "double", shape, time);
                measure_deal_ii<1, float>(cube, "float", shape, time);
              }
            else if (!of_tetrahedra)
              {
                measure_deal_ii<2, double>(cube, "double", shape, time);
                measure_deal_ii<2, float>(cube, "float", shape, time);
              }
            measure_matrix(cube, cells, shape, time);
          }
        for (const bool one_a_cell : {true, false})
          {
            const Cube  cube(degree, refinements + (degree == 1), of_tetrahedra, true);
            KernelCells cells = cube.cells();
            cells.tangents.assign(cells.size() * (one_a_cell ? 1 : cells.tangents_per_cell()),
                                  CellTangent());
            const char *const shape = one_a_cell ? "mean" : "points";
            for (const std::string &set : instruction_sets())
              {
                measure<double>(cube, cells, "double", shape, set, time);
                measure<float>(cube, cells, "float", shape, set, time);
              }
          }
      }
}
