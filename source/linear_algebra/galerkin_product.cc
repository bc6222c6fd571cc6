// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/galerkin_product.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/diagonal.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/own_range.h"
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      using Index = types::global_dof_index;
      using Row   = std::vector<std::pair<Index, double>>;
    } // namespace



    GalerkinProduct::GalerkinProduct(const NodeGraph &graph, const NodeInterpolation &P)
      : graph(graph)
      , P(P)
      , coarse(P.coarse)
    {
      std::sort(coarse.begin(), coarse.end());
      coarse.erase(std::unique(coarse.begin(), coarse.end()), coarse.end());
      for (const Index node : P.coarse)
        local.push_back(std::lower_bound(coarse.begin(), coarse.end(), node) - coarse.begin());
      place.resize(coarse.size());
      find_pattern();
      entries.resize(columns.size() * graph.n_components * graph.n_components, 0.);
    }



    // The row of a coarse node has the coarse nodes of the neighbours of all nodes that refer to
    // it.
    void
    GalerkinProduct::find_pattern()
    {
      const std::uint32_t        n = coarse.size();
      const SetsOfMembers        fine(P.first, local, n); // nodes that refer to each coarse node
      std::vector<std::uint32_t> seen_from(n, n);
      first.push_back(0);
      for (std::uint32_t c = 0; c < n; ++c)
        {
          const auto visit = [&](const std::uint32_t node) {
            for (std::size_t e = P.first[node]; e < P.first[node + 1]; ++e)
              if (seen_from[local[e]] != c)
                {
                  seen_from[local[e]] = c;
                  columns.push_back(local[e]);
                }
          };
          for (std::size_t f = fine.first[c]; f < fine.first[c + 1]; ++f)
            {
              const std::uint32_t node = fine.sets[f];
              visit(node);
              std::for_each(graph.begin(node), graph.end(node), visit);
            }
          std::sort(columns.begin() + first.back(), columns.end());
          first.push_back(columns.size());
        }
    }



    // Lists are short: a cell or the neighbours of a node refer to some tens of coarse nodes.
    void
    GalerkinProduct::gather(const std::uint32_t *begin, const std::uint32_t *end)
    {
      used.clear();
      for (; begin != end; ++begin)
        used.insert(used.end(),
                    local.begin() + P.first[*begin],
                    local.begin() + P.first[*begin + 1]);
      std::sort(used.begin(), used.end());
      used.erase(std::unique(used.begin(), used.end()), used.end());
      for (std::uint32_t i = 0; i < used.size(); ++i)
        place[used[i]] = i;
    }



    // The weights are the same for all components, so that blocks are multiplied as a whole.
    template <unsigned int n, typename Blocks>
    void
    GalerkinProduct::add_product(const std::uint32_t *begin,
                                 const std::uint32_t *end,
                                 const Blocks        &block,
                                 double              *row) const
    {
      for (; begin != end; ++begin)
        {
          const double *const values = block(*begin);
          for (std::size_t e = P.first[*begin]; e < P.first[*begin + 1]; ++e)
            {
              const double  weight = P.weights[e];
              double *const to     = row + std::size_t(place[local[e]]) * n * n;
              for (unsigned int i = 0; i < n * n; ++i)
                to[i] += weight * values[i];
            }
        }
    }



    template <unsigned int n>
    void
    GalerkinProduct::add_row(const std::uint32_t row, const double weight, const double *blocks)
    {
      std::size_t at = first[row];
      for (const std::uint32_t column : used)
        {
          // Both lists are in ascending order.
          while (columns[at] < column)
            ++at;
          double *const to = entries.data() + at * n * n;
          for (unsigned int i = 0; i < n * n; ++i)
            to[i] += weight * *blocks++;
        }
    }



    // For each node the row of K P, which is added to the rows of its coarse nodes.
    template <unsigned int n>
    void
    GalerkinProduct::add_matrix(const SparseMatrix &K)
    {
      std::vector<std::uint32_t> node_of, nodes;
      std::vector<unsigned char> component_of;
      for (const Index column : global_columns(K))
        {
          node_of.push_back(graph.local(column / n));
          component_of.push_back(column % n);
        }
      std::vector<std::array<double, n * n>> blocks(graph.size());
      for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
        {
          if (P.first[node] == P.first[node + 1])
            continue;
          nodes.assign(graph.begin(node), graph.end(node));
          nodes.push_back(node);
          for (const std::uint32_t other : nodes)
            blocks[other].fill(0.);
          for (unsigned int r = 0; r < n; ++r)
            if (graph.is_free(node, r))
              {
                const RowView row(K, node * n + r);
                for (int k = 0; k < row.size; ++k)
                  if (const std::uint32_t other = node_of[row.columns[k]];
                      graph.is_free(other, component_of[row.columns[k]]))
                    blocks[other][r * n + component_of[row.columns[k]]] = row.values[k];
              }
          gather(nodes.data(), nodes.data() + nodes.size());
          products.assign(used.size() * n * n, 0.);
          add_product<n>(
            nodes.data(),
            nodes.data() + nodes.size(),
            [&](const std::uint32_t other) { return blocks[other].data(); },
            products.data());
          for (std::size_t e = P.first[node]; e < P.first[node + 1]; ++e)
            add_row<n>(local[e], P.weights[e], products.data());
        }
    }



    void
    GalerkinProduct::add(const SparseMatrix &K)
    {
      if (graph.n_components == 2)
        add_matrix<2>(K);
      else
        add_matrix<3>(K);
    }



    // K_e P, then P^T of that, in a dense array of the coarse nodes of the cell, which is added to
    // the matrix at the end: rows of the matrix are searched once for each of them.
    template <unsigned int n>
    void
    GalerkinProduct::add_cell(const std::vector<std::uint32_t> &nodes,
                              const FullMatrix<double>         &matrix)
    {
      gather(nodes.data(), nodes.data() + nodes.size());
      const std::size_t length = used.size() * n * n;
      sums.assign(used.size() * length, 0.);
      std::array<double, n * n> block;
      for (unsigned int a = 0; a < nodes.size(); ++a)
        {
          if (P.first[nodes[a]] == P.first[nodes[a] + 1])
            continue;
          products.assign(length, 0.);
          unsigned int b = 0;
          add_product<n>(
            nodes.data(),
            nodes.data() + nodes.size(),
            [&](const std::uint32_t other) {
              for (unsigned int r = 0; r < n; ++r)
                for (unsigned int s = 0; s < n; ++s)
                  block[r * n + s] = graph.is_free(nodes[a], r) && graph.is_free(other, s) ?
                                       matrix(a * n + r, b * n + s) :
                                       0;
              ++b;
              return block.data();
            },
            products.data());
          for (std::size_t e = P.first[nodes[a]]; e < P.first[nodes[a] + 1]; ++e)
            {
              const double  weight = P.weights[e];
              double *const to     = sums.data() + place[local[e]] * length;
              for (std::size_t i = 0; i < length; ++i)
                to[i] += weight * products[i];
            }
        }
      for (std::uint32_t i = 0; i < used.size(); ++i)
        add_row<n>(used[i], 1., sums.data() + i * length);
    }



    void
    GalerkinProduct::add(const std::vector<std::uint32_t> &nodes, const FullMatrix<double> &matrix)
    {
      if (graph.n_components == 2)
        add_cell<2>(nodes, matrix);
      else
        add_cell<3>(nodes, matrix);
    }



    // Rows of other ranks are sent to their owners, and added there to those of this rank.
    SparseMatrix
    GalerkinProduct::finish()
    {
      const unsigned int n = graph.n_components;
      std::vector<Row>   rows(P.owned.n_elements() * n);
      const OwnRange     own(P.owned);
      IndexSet           of_others(P.owned.size());
      of_others.add_indices(coarse.begin(), coarse.end());
      of_others.subtract_set(P.owned);
      // In ascending order, as `coarse`.
      const std::vector<unsigned int> owners =
        Utilities::MPI::compute_index_owner(P.owned, of_others, graph.comm);
      std::map<unsigned int, std::vector<std::pair<Index, Row>>> sent;
      for (std::uint32_t c = 0; c < coarse.size(); ++c)
        for (unsigned int r = 0; r < n; ++r)
          {
            Row row;
            row.reserve((first[c + 1] - first[c]) * n);
            for (std::size_t b = first[c]; b < first[c + 1]; ++b)
              for (unsigned int s = 0; s < n; ++s)
                row.emplace_back(coarse[columns[b]] * n + s, entries[(b * n + r) * n + s]);
            if (own.has(coarse[c]))
              rows[own.local_index(coarse[c]) * n + r] = std::move(row);
            else
              sent[owners[of_others.index_within_set(coarse[c])]].emplace_back(coarse[c] * n + r,
                                                                               std::move(row));
          }
      for (const auto &[from, shares] : Utilities::MPI::some_to_some(graph.comm, sent))
        for (const auto &[i, row] : shares)
          {
            Row &to = rows[i - own.dof(0) * n];
            to.insert(to.end(), row.begin(), row.end());
          }
      const IndexSet unknowns = contiguous_partition(rows.size(), graph.comm);
      SparseMatrix   result   = matrix_of(rows, unknowns, unknowns, graph.comm);

      // A vector z of the null space has P z = 0 and no right-hand side, so that any positive value
      // will do, except for free rigid bodies: contact alone holds them, which is stiffer.
      constexpr double slight  = 1e-7;
      Vector           terms   = diagonal(result);
      const double     largest = terms.linfty_norm();
      for (double *d = values_of(terms); d != values_of(terms) + terms.locally_owned_size(); ++d)
        *d = slight * (*d > 0 ? *d : largest > 0 ? largest : 1);
      add_to_diagonal(result, terms);
      return result;
    }



    // Components that are not free have empty rows. Collective.
    SparseMatrix
    matrix_of(const NodeInterpolation &P, const NodeGraph &graph, const IndexSet &owned)
    {
      const unsigned int n = graph.n_components;
      std::vector<Row>   rows(owned.n_elements());
      for (std::uint32_t node = 0; node < graph.n_owned(); ++node)
        for (unsigned int c = 0; c < n; ++c)
          if (graph.is_free(node, c))
            for (std::size_t e = P.first[node]; e < P.first[node + 1]; ++e)
              rows[node * n + c].emplace_back(P.coarse[e] * n + c, P.weights[e]);
      return matrix_of(rows,
                       owned,
                       contiguous_partition(P.owned.n_elements() * n, graph.comm),
                       graph.comm);
    }
  } // namespace LA
} // namespace Signorini
