// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/direct_solver.h"
#include "linear_algebra/entries.h"
#include "linear_algebra/row_view.h"
#include "linear_algebra/values.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/OrderingMethods>

namespace Signorini
{
  namespace LA
  {
    namespace
    {
      using Matrix  = Eigen::SparseMatrix<double>;
      using Triplet = Eigen::Triplet<double>;

      /// The rows of a matrix of one rank, with the number of the unknown of each entry.
      class Rows
      {
      public:
        Rows(const SparseMatrix &matrix)
          : size(matrix.m())
          , matrix(matrix)
          , unknowns(global_columns(matrix))
        {}

        /// Call act(unknown, value) for the entries of a row.
        template <typename Action>
        void
        for_each_entry(const int i, const Action &act) const
        {
          const RowView row(matrix, i);
          for (int k = 0; k < row.size; ++k)
            act(static_cast<int>(unknowns[row.columns[k]]), row.values[k]);
        }

        const int size;

      private:
        const SparseMatrix                                &matrix;
        const std::vector<dealii::types::global_dof_index> unknowns;
      };

      /// The unknown behind which each is to be eliminated, that of its largest entry which is not
      /// taken by another yet; itself if its diagonal entry is not small.
      std::vector<int>
      partners(const Rows &rows)
      {
        // Diagonal entries below this share of the largest one in the row are no pivots.
        constexpr double  small = 1e-3;
        const int         n     = rows.size;
        std::vector<int>  result(n);
        std::vector<bool> is_taken(n, false);
        std::iota(result.begin(), result.end(), 0);
        for (int i = 0; i < n; ++i)
          {
            double diagonal = 0, largest = 0, best = 0;
            rows.for_each_entry(i, [&](const int j, const double value) {
              largest = std::max(largest, std::abs(value));
              if (j == i)
                diagonal = std::abs(value);
            });
            if (diagonal >= small * largest)
              continue;
            rows.for_each_entry(i, [&](const int j, const double value) {
              if (j == i || is_taken[j] || std::abs(value) <= best)
                return;
              best      = std::abs(value);
              result[i] = j;
            });
            is_taken[result[i]] = true;
          }
        return result;
      }

      /// The place of each unknown in the order of elimination.
      std::vector<int>
      places(const Rows &rows)
      {
        const int n = rows.size;
        // Unknowns and the partners behind which they are eliminated are one node of the graph.
        const std::vector<int> partner = partners(rows);
        std::vector<int>       node(n, -1);
        int                    n_nodes = 0;
        for (int i = 0; i < n; ++i)
          {
            // A chain of partners ends at an unknown that is its own, or closes.
            std::vector<int> chain;
            int              k = i;
            for (; node[k] < 0 && std::find(chain.begin(), chain.end(), k) == chain.end();
                 k = partner[k])
              chain.push_back(k);
            const int number = node[k] >= 0 ? node[k] : n_nodes++;
            for (const int member : chain)
              node[member] = number;
          }
        std::vector<Triplet> entries;
        for (int i = 0; i < n; ++i)
          rows.for_each_entry(i, [&](const int j, double) {
            entries.emplace_back(node[i], node[j], 1.);
            entries.emplace_back(node[j], node[i], 1.);
          });
        Matrix graph(n_nodes, n_nodes);
        graph.setFromTriplets(entries.begin(), entries.end());
        Eigen::AMDOrdering<int>                  order_graph;
        Eigen::AMDOrdering<int>::PermutationType order; // [place] = node
        order_graph(graph, order);
        std::vector<int> place_of_node(n_nodes), order_of_unknowns(n), result(n);
        for (int k = 0; k < n_nodes; ++k)
          place_of_node[order.indices()[k]] = k;
        std::iota(order_of_unknowns.begin(), order_of_unknowns.end(), 0);
        std::stable_sort(order_of_unknowns.begin(),
                         order_of_unknowns.end(),
                         [&](const int i, const int j) {
                           const int a = place_of_node[node[i]], b = place_of_node[node[j]];
                           return a != b ? a < b : (partner[i] != i) < (partner[j] != j);
                         });
        for (int k = 0; k < n; ++k)
          result[order_of_unknowns[k]] = k;
        return result;
      }
    } // namespace



    bool
    OrderedLU::factorise(const SparseMatrix &matrix)
    {
      // Diagonal pivots are taken down to this share of the largest entry of their column.
      constexpr double threshold = 1e-3;
      const Rows       rows(matrix);
      const int        n = rows.size;
      place              = places(rows);
      std::vector<Triplet> entries;
      for (int i = 0; i < n; ++i)
        rows.for_each_entry(i, [&](const int j, const double value) {
          entries.emplace_back(place[i], place[j], value);
        });
      Matrix sorted(n, n);
      sorted.setFromTriplets(entries.begin(), entries.end());
      factors.isSymmetric(true);
      factors.setPivotThreshold(threshold);
      factors.analyzePattern(sorted);
      factors.factorize(sorted);
      ordered.resize(n);
      return factors.info() == Eigen::Success;
    }



    void
    OrderedLU::solve(Vector &x, const Vector &right) const
    {
      const double *const from = values_of(right);
      for (unsigned int i = 0; i < place.size(); ++i)
        ordered[place[i]] = from[i];
      ordered          = factors.solve(ordered).eval();
      double *const to = values_of(x);
      for (unsigned int i = 0; i < place.size(); ++i)
        to[i] = ordered[place[i]];
    }
  } // namespace LA
} // namespace Signorini
