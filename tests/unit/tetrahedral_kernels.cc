// SPDX-License-Identifier: Apache-2.0
// Products of tetrahedra without matrices against integrals with deal.II's polynomials.

#include "geometry/cell_rule.h"
#include "matrix_free/cell_kernel.h"
#include "matrix_free/cell_matrices.h"
#include "matrix_free/instruction_sets.h"

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace dealii;
using namespace Signorini;

namespace
{
  constexpr unsigned int n_cells = 21; // fills no batch

  std::mt19937 noise_source;

  double
  noise()
  {
    return std::uniform_real_distribution<double>(-1, 1)(noise_source);
  }

  /// Tetrahedra that share nodes, every third one straight, the others with moved nodes.
  KernelCells
  tetrahedra(const unsigned int degree)
  {
    const FE_SimplexP<3> fe(degree);
    KernelCells          cells;
    cells.degree         = degree;
    cells.are_tetrahedra = true;
    const unsigned int n = fe.n_dofs_per_cell();
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const Point<3> x    = fe.unit_support_point(i);
            const double   bend = cell % 3 == 0 ? 0 : 0.05;
            for (const double position : {x[0] + 0.3 * x[1], x[1], (1 + 0.1 * cell) * x[2]})
              cells.points.push_back(position + bend * noise());
            cells.nodes.push_back(3 * ((i * 5 + cell * 3) % (2 * n)));
          }
        cells.lambda.push_back(1 + 0.1 * cell);
        cells.mu.push_back(2 - 0.05 * cell);
      }
    return cells;
  }

  /// Gradients of the shape functions in reference coordinates.
  std::vector<Tensor<1, 3>>
  gradients(const unsigned int degree, const Point<3> &xi)
  {
    const FE_SimplexP<3>      fe(degree);
    std::vector<Tensor<1, 3>> result;
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      result.push_back(fe.shape_grad(i, xi));
    return result;
  }

  /// f += the product with the tangent at one point, or with the moduli if there is none.
  void
  add_point(const KernelCells         &cells,
            const unsigned int         cell,
            const Point<3>            &xi,
            const double               weight,
            const CellTangent         *tangent,
            const std::vector<double> &u,
            std::vector<double>       &f)
  {
    const unsigned int         n      = cells.nodes_per_cell();
    const auto                 slopes = gradients(cells.degree, xi);
    const std::uint32_t *const nodes  = &cells.nodes[cell * n];
    Tensor<2, 3>               G, S, J; // du_c/dxi_d
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          {
            G[c][d] += u[nodes[i] + c] * slopes[i][d];
            if (!tangent)
              J[c][d] += cells.points[3 * (cell * n + i) + c] * slopes[i][d];
          }
    if (tangent)
      for (unsigned int k = 0; k < 9; ++k)
        for (unsigned int m = 0; m < 9; ++m)
          S[k / 3][k % 3] += (*tangent)[tangent_number(k, m)] * G[m / 3][m % 3];
    else
      {
        const Tensor<2, 3> gradient = G * invert(J),
                           strain   = 0.5 * (gradient + transpose(gradient));
        Tensor<2, 3> stress         = 2 * cells.mu[cell] * strain;
        for (unsigned int c = 0; c < 3; ++c)
          stress[c][c] += cells.lambda[cell] * trace(strain);
        S = weight * determinant(J) * stress * transpose(invert(J));
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          f[nodes[i] + c] += S[c][d] * slopes[i][d];
  }

  /// The product by quadrature.
  std::vector<double>
  by_quadrature(const KernelCells         &cells,
                const std::vector<double> &u,
                const CellTangents        *of_points = nullptr)
  {
    std::vector<double>  f(u.size(), 0.);
    const Quadrature<3> &rule =
      cell_rule<3>(ReferenceCells::Tetrahedron, cells.degree == 1 ? 1 : 3);
    const std::size_t n_tangents = cells.tangents.size() / cells.size();
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          // One tangent of a cell is an integral over its volume of one sixth.
          CellTangent tangent{};
          for (unsigned int k = 0; n_tangents > 0 && k < n_tangent_numbers; ++k)
            tangent[k] = n_tangents == 1 ? cells.tangents[cell][k] * 6 * rule.weight(q) :
                                           (*of_points)[cell * rule.size() + q][k];
          add_point(
            cells, cell, rule.point(q), rule.weight(q), n_tangents > 0 ? &tangent : nullptr, u, f);
        }
    return f;
  }

  /// Products in both precisions and diagonals of all instruction sets.
  void
  check_kernels(const KernelCells &cells, const CellTangents *of_points = nullptr)
  {
    std::vector<double> u(6 * cells.nodes_per_cell());
    for (double &value : u)
      value = noise();
    std::vector<float> single_precision(u.begin(), u.end());
    single_precision.push_back(0); // may be read
    const std::vector<double> exact = by_quadrature(cells, u, of_points);
    double                    size  = 0;
    for (const double value : exact)
      size = std::max(size, std::abs(value));
    REQUIRE(size > 0.1);

    std::vector<double>       diagonal(u.size(), 0.);
    std::vector<unsigned int> all;
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      all.push_back(cell);
    const CellMatrices matrices(cells, all);
    for (const unsigned int cell : all)
      for (unsigned int i = 0; i < 3 * cells.nodes_per_cell(); ++i)
        diagonal[cells.nodes[cell * cells.nodes_per_cell() + i / 3] + i % 3] +=
          matrices.matrix(cell)(i, i);

    for (const std::string &set : instruction_sets())
      {
        CAPTURE(set);
        std::vector<double> f(u.size(), 0.), d(u.size(), 0.);
        std::vector<float>  g(u.size(), 0.f);
        CellKernel<double>::create(cells, set)->add_product(f.data(), u.data());
        CellKernel<double>::create(cells, set)->add_diagonal(d.data());
        CellKernel<float>::create(cells, set)->add_product(g.data(), single_precision.data());
        double worst = 0, worst_rounded = 0, worst_diagonal = 0;
        for (unsigned int i = 0; i < u.size(); ++i)
          {
            worst          = std::max(worst, std::abs(f[i] - exact[i]));
            worst_rounded  = std::max(worst_rounded, std::abs(g[i] - exact[i]));
            worst_diagonal = std::max(worst_diagonal, std::abs(d[i] - diagonal[i]));
          }
        // Tangents and their moments are stored in single precision.
        CHECK(worst < (cells.has_tangents() ? 1e-6 : 1e-12) * size);
        CHECK(worst_rounded < 1e-5 * size);
        CHECK(worst_diagonal < 1e-12 * size);
      }
  }
} // namespace



TEST_CASE("products of tetrahedra are integrals over straight and curved cells")
{
  for (const unsigned int degree : {1, 2})
    {
      CAPTURE(degree);
      const KernelCells cells = tetrahedra(degree);
      check_kernels(cells);
      // Rigid-body motions have no stress, whatever the shape of the cell is.
      const unsigned int n = cells.nodes_per_cell();
      for (unsigned int cell = 0; cell < cells.size(); ++cell)
        {
          const CellMatrices matrices(cells, {cell});
          Vector<double>     u(3 * n), f(3 * n);
          for (unsigned int i = 0; i < n; ++i)
            {
              const double *x = &cells.points[3 * (cell * n + i)];
              u(3 * i)        = 1 - 2 * x[1];
              u(3 * i + 1)    = 2 * x[0] + 3 * x[2];
              u(3 * i + 2)    = -3 * x[1];
            }
          matrices.matrix(0).vmult(f, u);
          CHECK(f.linfty_norm() < 1e-12);
        }
    }
}



TEST_CASE("products of tangents of tetrahedra are integrals, for one a cell and one a point")
{
  for (const unsigned int degree : {1, 2})
    for (const bool one_a_cell : {true, false})
      {
        KernelCells cells = tetrahedra(degree);
        cells.points.clear();
        const unsigned int n_points = one_a_cell ? 1 : cells.points_per_cell();
        CellTangents       of_points(n_cells * n_points);
        for (CellTangent &tangent : of_points)
          for (float &number : tangent)
            number = noise();
        cells.tangents = of_points;
        if (degree == 2 && !one_a_cell)
          {
            // Kernels get the moments of the tangents of the points.
            const SimplexTables<double, 2> tables;
            cells.tangents.assign(n_cells * tables.n_moments, CellTangent{});
            for (unsigned int cell = 0; cell < n_cells; ++cell)
              for (unsigned int q = 0; q < n_points; ++q)
                for (unsigned int a = 0; a < 4; ++a)
                  for (unsigned int b = 0; b <= a; ++b)
                    for (unsigned int k = 0; k < n_tangent_numbers; ++k)
                      cells.tangents[cell * tables.n_moments + tables.moment(a, b)][k] +=
                        tables.moment_factor(q, a, b) * of_points[cell * n_points + q][k];
          }
        check_kernels(cells, &of_points);
      }
}
