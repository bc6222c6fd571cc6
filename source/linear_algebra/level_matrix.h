// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/ghost_exchange.h"
#include "linear_algebra/types.h"

#include <vector>

namespace Signorini
{
  namespace LA
  {
    /// A matrix as the levels of a multigrid method use it: vectors are arrays of the elements of
    /// this rank, in single precision, and so are the entries, a copy of those of the matrix. They
    /// are stored in dense blocks of a few rows and columns, such as those of two nodes, with one
    /// index for each block: products read about a third of the bytes of the matrix, and take as
    /// long as reading them. Products are collective.
    class LevelMatrix
    {
    public:
      explicit LevelMatrix(const SparseMatrix &A);

      /// dst = A src
      void
      vmult(float *dst, const float *src) const;

      /// dst += A src
      void
      vmult_add(float *dst, const float *src) const;

      /// dst = A^T src
      void
      Tvmult(float *dst, const float *src) const;

      /// dst += A^T src
      void
      Tvmult_add(float *dst, const float *src) const;

      /// Number of local columns: of those that the rows of this rank refer to.
      unsigned int
      n_columns() const
      {
        return places.size();
      }

      /// Add values by local column to the elements of their owners. @param dst owned elements of a
      /// vector to which A can be applied
      void
      add_columns(const float *values, float *dst) const;

      /// The size of blocks.
      struct Shape
      {
        unsigned int rows, columns;
      };

      Shape
      shape() const
      {
        return my_shape;
      }

    private:
      /// Copy the entries into blocks.
      void
      copy(const SparseMatrix &A);
      /// The elements of src, owned ones and ghosts behind them. Collective.
      const float *
      fetch(const float *src) const;
      /// Add `around`, elements by place, to their owners. Collective.
      void
      add_around(float *dst) const;
      template <unsigned int rows, unsigned int columns>
      void
      multiply(float *dst, const float *x) const;
      template <unsigned int rows, unsigned int columns>
      void
      multiply_transposed(float *dst, const float *x) const;

      const Shape                my_shape;
      const unsigned int         n_rows;
      GhostExchange<float>       exchange;
      std::vector<std::uint32_t> places;       ///< of local columns: owned elements, then ghosts
      std::vector<std::uint32_t> first_block;  ///< of each row of blocks
      std::vector<std::uint32_t> block_column; ///< place of the first column / columns of a block
      std::vector<float>         entries;      ///< of the blocks, column by column
      mutable std::vector<float> around;       ///< elements by place
    };
  } // namespace LA
} // namespace Signorini
