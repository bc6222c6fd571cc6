// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/level_matrix.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/row_view.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      using Shape = LevelMatrix::Shape;

      /// The rows and columns that blocks may have: of one entry, of nodes in the plane and in
      /// space, of the rigid-body modes of aggregates there.
      constexpr std::array<unsigned int, 4> sizes{{1, 2, 3, 6}};

      /// For each size 1 if it divides the number of owned columns of all ranks, so that no block
      /// has columns of two owners. Collective.
      std::vector<int>
      possible_columns(const SparseMatrix &A)
      {
        std::vector<int> result(sizes.size());
        for (unsigned int s = 0; s < sizes.size(); ++s)
          result[s] = A.locally_owned_domain_indices().n_elements() % sizes[s] == 0;
        std::vector<int> of_all(sizes.size());
        Utilities::MPI::min(result, A.get_mpi_communicator(), of_all);
        return of_all;
      }

      /// The bytes of blocks of this shape, from every `step`-th row of them.
      std::size_t
      bytes_of(const SparseMatrix                         &A,
               const std::vector<types::global_dof_index> &columns,
               const Shape                                &shape,
               const unsigned int                          step)
      {
        const unsigned int                   n_rows = A.trilinos_matrix().NumMyRows() / shape.rows;
        std::size_t                          bytes  = 0;
        std::vector<types::global_dof_index> blocks;
        for (unsigned int i = 0; i < n_rows; i += step)
          {
            blocks.clear();
            for (unsigned int r = 0; r < shape.rows; ++r)
              {
                const RowView row(A, i * shape.rows + r);
                for (int k = 0; k < row.size; ++k)
                  blocks.push_back(columns[row.columns[k]] / shape.columns);
              }
            std::sort(blocks.begin(), blocks.end());
            const std::size_t n = std::unique(blocks.begin(), blocks.end()) - blocks.begin();
            bytes += sizeof(std::uint32_t) +
                     n * (sizeof(std::uint32_t) + shape.rows * shape.columns * sizeof(float));
          }
        // Different shapes have different numbers of rows in the sample.
        const unsigned int n_sampled = (n_rows + step - 1) / step;
        return n_sampled > 0 ? bytes * n_rows / n_sampled : 0;
      }

      /// The shape that takes the fewest bytes. Collective.
      Shape
      best_shape(const SparseMatrix &A)
      {
        constexpr unsigned int n_sampled = 500;
        const std::vector<int> possible  = possible_columns(A);
        const auto             columns   = global_columns(A);
        const unsigned int     n_rows    = A.trilinos_matrix().NumMyRows();
        Shape                  best{1, 1};
        std::size_t            least = std::numeric_limits<std::size_t>::max();
        for (const unsigned int rows : sizes)
          for (unsigned int s = 0; s < sizes.size(); ++s)
            if (n_rows % rows == 0 && possible[s])
              {
                const Shape       shape{rows, sizes[s]};
                const std::size_t bytes =
                  bytes_of(A, columns, shape, std::max(1u, n_rows / rows / n_sampled));
                if (bytes < least)
                  {
                    least = bytes;
                    best  = shape;
                  }
              }
        return best;
      }

      /// The columns of other ranks in the blocks of the rows of this rank.
      IndexSet
      ghosts_of(const SparseMatrix &A, const Shape &shape)
      {
        const IndexSet                       owned = A.locally_owned_domain_indices();
        std::vector<types::global_dof_index> others;
        for (const auto column : global_columns(A))
          if (!owned.is_element(column))
            for (unsigned int c = 0; c < shape.columns; ++c)
              others.push_back(column / shape.columns * shape.columns + c);
        std::sort(others.begin(), others.end());
        IndexSet result(owned.size());
        result.add_indices(others.begin(), others.end());
        return result;
      }

      /// Call visit(R, C) with the shape as constants.
      template <typename Visitor>
      void
      with_constant(const Shape &shape, const Visitor &visit)
      {
        const auto with_rows = [&](const auto rows) {
          switch (shape.columns)
            {
              case 1:
                return visit(rows, std::integral_constant<unsigned int, 1>());
              case 2:
                return visit(rows, std::integral_constant<unsigned int, 2>());
              case 3:
                return visit(rows, std::integral_constant<unsigned int, 3>());
              default:
                return visit(rows, std::integral_constant<unsigned int, 6>());
            }
        };
        switch (shape.rows)
          {
            case 1:
              return with_rows(std::integral_constant<unsigned int, 1>());
            case 2:
              return with_rows(std::integral_constant<unsigned int, 2>());
            case 3:
              return with_rows(std::integral_constant<unsigned int, 3>());
            default:
              return with_rows(std::integral_constant<unsigned int, 6>());
          }
      }
    } // namespace



    LevelMatrix::LevelMatrix(const SparseMatrix &A)
      : my_shape(best_shape(A))
      , n_rows(A.trilinos_matrix().NumMyRows())
      , exchange(A.locally_owned_domain_indices(), ghosts_of(A, my_shape), A.get_mpi_communicator())
      , around(exchange.n_owned() + exchange.n_ghosts())
    {
      for (const auto column : global_columns(A))
        places.push_back(exchange.local_index(column));
      copy(A);
    }



    // Row by row of blocks: `slots` has the number of the block of each column of blocks in the
    // present row. Blocks are in the order in which rows refer to them.
    void
    LevelMatrix::copy(const SparseMatrix &A)
    {
      const auto [rows, columns]      = my_shape;
      constexpr std::uint32_t    none = std::numeric_limits<std::uint32_t>::max();
      std::vector<std::uint32_t> slots(around.size() / columns, none);
      first_block.reserve(n_rows / rows + 1);
      first_block.push_back(0);
      for (unsigned int i = 0; i < n_rows; i += rows)
        {
          for (unsigned int r = 0; r < rows; ++r)
            {
              const RowView row(A, i + r);
              for (int k = 0; k < row.size; ++k)
                {
                  const std::uint32_t place  = places[row.columns[k]];
                  const std::uint32_t column = place / columns;
                  if (slots[column] == none)
                    {
                      slots[column] = block_column.size();
                      block_column.push_back(column);
                      entries.resize(entries.size() + rows * columns, 0.f);
                    }
                  entries[(std::size_t(slots[column]) * columns + place % columns) * rows + r] +=
                    row.values[k];
                }
            }
          for (std::size_t block = first_block.back(); block < block_column.size(); ++block)
            slots[block_column[block]] = none;
          first_block.push_back(block_column.size());
        }
      entries.shrink_to_fit();
      block_column.shrink_to_fit();
    }



    // Without ghosts the elements are where they should be. Collective.
    const float *
    LevelMatrix::fetch(const float *src) const
    {
      if (exchange.n_ghosts() == 0)
        {
          exchange.fetch(src, nullptr);
          return src;
        }
      const std::size_t n = exchange.n_owned();
      std::copy_n(src, n, around.begin());
      exchange.fetch(src, around.data() + n);
      return around.data();
    }



    void
    LevelMatrix::add_around(float *dst) const
    {
      const std::size_t n = exchange.n_owned();
      for (std::size_t i = 0; i < n; ++i)
        dst[i] += around[i];
      exchange.add(around.data() + n, dst);
    }



    // The sums of the rows of a block are independent of each other, for the compiler to compute
    // them side by side.
    template <unsigned int rows, unsigned int columns>
    void
    LevelMatrix::multiply(float *dst, const float *x) const
    {
      const float *entry = entries.data();
      for (std::size_t i = 0; i + 1 < first_block.size(); ++i)
        {
          std::array<float, rows> sum{};
          for (std::size_t block = first_block[i]; block < first_block[i + 1]; ++block)
            {
              const float *const from = x + std::size_t(block_column[block]) * columns;
              for (unsigned int c = 0; c < columns; ++c)
                for (unsigned int r = 0; r < rows; ++r)
                  sum[r] += entry[c * rows + r] * from[c];
              entry += rows * columns;
            }
          for (unsigned int r = 0; r < rows; ++r)
            dst[i * rows + r] += sum[r];
        }
    }



    template <unsigned int rows, unsigned int columns>
    void
    LevelMatrix::multiply_transposed(float *dst, const float *x) const
    {
      const float *entry = entries.data();
      for (std::size_t i = 0; i + 1 < first_block.size(); ++i)
        for (std::size_t block = first_block[i]; block < first_block[i + 1]; ++block)
          {
            float *const to = dst + std::size_t(block_column[block]) * columns;
            for (unsigned int c = 0; c < columns; ++c)
              {
                float sum = 0;
                for (unsigned int r = 0; r < rows; ++r)
                  sum += entry[c * rows + r] * x[i * rows + r];
                to[c] += sum;
              }
            entry += rows * columns;
          }
    }



    void
    LevelMatrix::vmult(float *dst, const float *src) const
    {
      std::fill_n(dst, n_rows, 0.f);
      vmult_add(dst, src);
    }



    void
    LevelMatrix::vmult_add(float *dst, const float *src) const
    {
      const float *const x = fetch(src);
      with_constant(my_shape, [&](const auto rows, const auto columns) {
        multiply<rows(), columns()>(dst, x);
      });
    }



    void
    LevelMatrix::Tvmult(float *dst, const float *src) const
    {
      std::fill_n(dst, exchange.n_owned(), 0.f);
      Tvmult_add(dst, src);
    }



    void
    LevelMatrix::Tvmult_add(float *dst, const float *src) const
    {
      std::fill(around.begin(), around.end(), 0.f);
      with_constant(my_shape, [&](const auto rows, const auto columns) {
        multiply_transposed<rows(), columns()>(around.data(), src);
      });
      add_around(dst);
    }



    // Columns of the matrix are a part of the places. Collective.
    void
    LevelMatrix::add_columns(const float *values, float *dst) const
    {
      std::fill(around.begin(), around.end(), 0.f);
      for (std::size_t k = 0; k < places.size(); ++k)
        around[places[k]] += values[k];
      add_around(dst);
    }
  } // namespace LA
} // namespace Signorini
