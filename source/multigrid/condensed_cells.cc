// SPDX-License-Identifier: Apache-2.0
#include "multigrid/condensed_cells.h"

#include "linear_algebra/values.h"
#include "matrix_free/cell_matrices.h"

#include <algorithm>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  // Nodes in the order of the cell, or, where others are added, by number.
  CondensedCells::CondensedCells(const CellSpace &space)
    : space(space)
  {
    for (const KernelCells &cells : space.cells)
      {
        const unsigned int n = cells.nodes_per_cell();
        for (unsigned int cell = 0; cell < cells.size(); ++cell)
          {
            const std::uint32_t *const first = &cells.nodes[std::size_t(n) * cell];
            for (unsigned int i = 0; i < n; ++i)
              sets.nodes.push_back(first[i] / dim);
            const auto others = masters(cells, cell);
            is_dependent.push_back(!others.empty());
            if (is_dependent.back())
              {
                sets.nodes.insert(sets.nodes.end(), others.begin(), others.end());
                const auto begin = sets.nodes.begin() + sets.first.back();
                std::sort(begin, sets.nodes.end());
                sets.nodes.erase(std::unique(begin, sets.nodes.end()), sets.nodes.end());
              }
            sets.first.push_back(sets.nodes.size());
          }
      }
  }



  std::vector<types::global_dof_index>
  CondensedCells::masters(const KernelCells &cells, const unsigned int cell) const
  {
    constexpr unsigned int               many  = 500; // entries of constraints
    const unsigned int                   n     = cells.nodes_per_cell();
    const std::uint32_t *const           first = &cells.nodes[std::size_t(n) * cell];
    std::vector<types::global_dof_index> result;
    for (unsigned int i = 0; i < n * dim; ++i)
      if (const auto *line = space.constraints.get_constraint_entries(first[i / dim] + i % dim))
        {
          if (line->size() > many)
            return {};
          for (const auto &entry : *line)
            result.push_back(entry.first / dim);
        }
    return result;
  }



  // C^T K C, where row i of C expresses unknown i of the cell by free ones.
  FullMatrix<double>
  CondensedCells::condense(const KernelCells        &cells,
                           const unsigned int        cell,
                           const std::size_t         set,
                           const FullMatrix<double> &matrix) const
  {
    const auto begin     = sets.nodes.begin() + sets.first[set],
               end       = sets.nodes.begin() + sets.first[set + 1];
    const unsigned int n = cells.nodes_per_cell();
    FullMatrix<double> C(n * dim, (end - begin) * dim);
    const auto         column = [&](const types::global_dof_index dof) {
      return (std::lower_bound(begin, end, dof / dim) - begin) * dim + dof % dim;
    };
    for (unsigned int i = 0; i < n * dim; ++i)
      {
        const types::global_dof_index dof = cells.nodes[std::size_t(n) * cell + i / dim] + i % dim;
        if (!space.constraints.is_constrained(dof))
          C(i, column(dof)) = 1;
        else
          for (const auto &[other, weight] : *space.constraints.get_constraint_entries(dof))
            C(i, column(other)) += weight;
      }
    FullMatrix<double> KC(n * dim, C.n()), result(C.n(), C.n());
    matrix.mmult(KC, C);
    C.Tmmult(result, KC);
    return result;
  }



  void
  CondensedCells::add_to(LA::GalerkinProduct &product, const LA::NodeGraph &graph) const
  {
    // As many matrices at a time as stay in the processor's cache.
    constexpr unsigned int     at_once = 256;
    std::size_t                set     = 0;
    std::vector<std::uint32_t> local;
    for (const KernelCells &cells : space.cells)
      for (unsigned int first = 0; first < cells.size(); first += at_once)
        {
          std::vector<unsigned int> some(std::min(at_once, cells.size() - first));
          std::iota(some.begin(), some.end(), first);
          const CellMatrices matrices(cells, some);
          for (unsigned int k = 0; k < some.size(); ++k, ++set)
            {
              local.clear();
              for (std::size_t i = sets.first[set]; i < sets.first[set + 1]; ++i)
                local.push_back(graph.local(sets.nodes[i]));
              const FullMatrix<double> matrix = matrices.matrix(k);
              product.add(local,
                          is_dependent[set] ? condense(cells, some[k], set, matrix) : matrix);
            }
        }
    // Diagonal terms of this rank's nodes.
    FullMatrix<double>  terms(dim, dim);
    const double *const diagonal = LA::values_of(space.diagonal_terms);
    for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
      if (std::any_of(diagonal + node * dim, diagonal + (node + 1) * dim, [](const double d) {
            return d != 0;
          }))
        {
          for (unsigned int c = 0; c < dim; ++c)
            terms(c, c) = diagonal[node * dim + c];
          product.add({node}, terms);
        }
  }
} // namespace Signorini
