// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/node_graph.h"

#include <deal.II/lac/full_matrix.h>

#include <utility>
#include <vector>

namespace Signorini
{
  namespace LA
  {
    /// The interpolation P of the unknowns of nodes from those of coarse nodes, with the same
    /// weights for all components. Prescribed unknowns get nothing.
    struct NodeInterpolation
    {
      using Index = dealii::types::global_dof_index;

      std::vector<std::size_t> first;  ///< entry of each local node, and the end
      std::vector<Index>       coarse; ///< global numbers of different coarse nodes for each node
      std::vector<double>      weights;
      dealii::IndexSet         owned; ///< coarse nodes of this rank, consecutive by rank
    };

    /// P as a matrix. Collective. @param owned unknowns of this rank
    SparseMatrix
    matrix_of(const NodeInterpolation &P, const NodeGraph &graph, const dealii::IndexSet &owned);

    /// The product P^T K P, of a matrix K or of matrices of cells. Refers to its arguments.
    class GalerkinProduct
    {
    public:
      /// @param graph of K
      GalerkinProduct(const NodeGraph &graph, const NodeInterpolation &P);

      /// Add the product of a matrix whose graph it is.
      void
      add(const SparseMatrix &K);

      /// Add the product of a matrix of coupled nodes.
      /// @param nodes their local numbers
      /// @param matrix rows and columns of all components, node by node
      void
      add(const std::vector<std::uint32_t> &nodes, const dealii::FullMatrix<double> &matrix);

      /// The matrix, to which positive diagonal entries are added where it is or may be singular:
      /// for coarse unknowns on which no free one depends, or of which several act on the same
      /// ones. Collective.
      SparseMatrix
      finish();

    private:
      using Index = NodeInterpolation::Index;

      /// Find the pattern of the rows to which this rank contributes.
      void
      find_pattern();
      /// Number the coarse nodes of some local nodes in `used`, in ascending order.
      void
      gather(const std::uint32_t *begin, const std::uint32_t *end);
      /// For a node and `matrix(other)`, the block of its row at another one: its row of K P, by
      /// `used`.
      template <unsigned int n, typename Blocks>
      void
      add_product(const std::uint32_t *begin,
                  const std::uint32_t *end,
                  const Blocks        &block,
                  double              *row) const;
      /// Add blocks, by `used`, to a row.
      template <unsigned int n>
      void
      add_row(std::uint32_t row, double weight, const double *blocks);
      template <unsigned int n>
      void
      add_matrix(const SparseMatrix &K);
      template <unsigned int n>
      void
      add_cell(const std::vector<std::uint32_t> &nodes, const dealii::FullMatrix<double> &matrix);

      const NodeGraph           &graph;
      const NodeInterpolation   &P;
      std::vector<Index>         coarse;  ///< to which local nodes refer, in ascending order
      std::vector<std::uint32_t> local;   ///< places in `coarse` of the entries of P
      std::vector<std::size_t>   first;   ///< block of each row, by place in `coarse`
      std::vector<std::uint32_t> columns; ///< of blocks, ascending in each row
      std::vector<double>        entries; ///< of blocks, row by row
      std::vector<std::uint32_t> used;    ///< see gather()
      std::vector<std::uint32_t> place;   ///< of coarse nodes in `used`
      std::vector<double>        products, sums;
    };
  } // namespace LA
} // namespace Signorini
