// SPDX-License-Identifier: Apache-2.0
// How fast kernels multiply, in each instruction set of this processor, beside what its memory
// bears.
//
//   products [refinements of a cube, 5] [seconds for each number, 0.5]
//
// One process. Affine cells are a cube's; general ones are the same with their vertices moved; then
// tangents, one a cell and one a point.

#include "matrix_free/cell_kernel.h"
#include "matrix_free/instruction_sets.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>

using namespace dealii;
using namespace Signorini;

namespace
{
  constexpr int dim = 3;

  /// Of a cube, refined that often, numbered as the program does.
  KernelCells
  cells_of_cube(const unsigned int degree, const unsigned int refinements, const bool affine)
  {
    Triangulation<dim> triangulation;
    GridGenerator::hyper_cube(triangulation);
    triangulation.refine_global(refinements);
    if (!affine)
      GridTools::transform(
        [](const Point<dim> &x) {
          return x + 0.1 * Point<dim>(x[1] * x[2], x[0] * x[2], x[0] * x[1]);
        },
        triangulation);
    const FESystem<dim> element(FE_Q<dim>(degree), dim);
    DoFHandler<dim>     dofs(triangulation);
    dofs.distribute_dofs(element);
    const auto         &scalar  = dynamic_cast<const FE_Q<dim> &>(element.base_element(0));
    const auto          lattice = scalar.get_poly_space_numbering_inverse();
    const MappingQ<dim> mapping(1);
    std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
    KernelCells                          cells;
    cells.degree = degree;
    for (const auto &cell : dofs.active_cell_iterators())
      {
        cell->get_dof_indices(indices);
        for (const unsigned int node : lattice)
          {
            cells.nodes.push_back(indices[element.component_to_system_index(0, node)]);
            const Point<dim> x =
              mapping.transform_unit_to_real_cell(cell, scalar.unit_support_point(node));
            cells.points.insert(cells.points.end(), x.begin_raw(), x.end_raw());
          }
        cells.lambda.push_back(1);
        cells.mu.push_back(1);
      }
    return cells;
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
  measure(const KernelCells &cells,
          const char        *precision,
          const char        *shape,
          const std::string &set,
          const double       time)
  {
    const auto  kernel = CellKernel<Number>::create(cells, set);
    std::size_t n_dofs = 0;
    for (const auto node : cells.nodes)
      n_dofs = std::max<std::size_t>(n_dofs, node + 3);
    // A kernel may read one element behind the last one.
    std::vector<Number> u(n_dofs + 1, 1), f(n_dofs + 1, 0);
    for (std::size_t i = 0; i < n_dofs; ++i)
      u[i] = Number(i % 7) - 3;
    const double t     = seconds(time, [&] { kernel->add_product(f.data(), u.data()); });
    const double bytes = kernel->memory_consumption() + 3. * n_dofs * sizeof(Number);
    std::printf("%6u  %-9s  %-8s  %-8s  %10zu  %8.0f  %9.0f  %6.1f\n",
                cells.degree,
                precision,
                shape,
                set.c_str(),
                n_dofs,
                n_dofs / t / 1e6,
                bytes / n_dofs,
                bytes / t / 1e9);
    std::fflush(stdout);
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
main(const int argc, char **argv)
{
  const unsigned int refinements = argc > 1 ? std::atoi(argv[1]) : 5;
  const double       time        = argc > 2 ? std::atof(argv[2]) : 0.5;
  measure_memory(time);
  std::printf("degree  precision  cells     set             dofs   Mdofs/s  bytes/dof    GB/s\n");
  for (const unsigned int degree : {1u, 2u})
    for (const bool affine : {true, false})
      {
        const KernelCells cells = cells_of_cube(degree, refinements + (degree == 1), affine);
        for (const std::string &set : instruction_sets())
          {
            const char *shape = affine ? "affine" : "general";
            measure<double>(cells, "double", shape, set, time);
            measure<float>(cells, "float", shape, set, time);
          }
      }
  for (const unsigned int degree : {1u, 2u})
    for (const bool one_a_cell : {true, false})
      {
        KernelCells       cells   = cells_of_cube(degree, refinements + (degree == 1), true);
        const std::size_t n_cells = cells.size();
        cells.tangents.assign(n_cells * (one_a_cell ? 1 : cells.nodes_per_cell()), CellTangent());
        for (const std::string &set : instruction_sets())
          {
            const char *shape = one_a_cell ? "mean" : "points";
            measure<double>(cells, "double", shape, set, time);
            measure<float>(cells, "float", shape, set, time);
          }
      }
}
