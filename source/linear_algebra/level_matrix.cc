// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/level_matrix.h"

#include "linear_algebra/columns.h"
#include "linear_algebra/row_view.h"

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace LA
  {
    namespace
    {
      /// The columns of other ranks that the rows of this rank refer to.
      IndexSet
      ghosts_of(const SparseMatrix &A)
      {
        const IndexSet                       owned = A.locally_owned_domain_indices();
        std::vector<types::global_dof_index> others;
        for (const auto column : global_columns(A))
          if (!owned.is_element(column))
            others.push_back(column);
        std::sort(others.begin(), others.end());
        IndexSet result(owned.size());
        result.add_indices(others.begin(), others.end());
        return result;
      }
    } // namespace



    // The columns of Trilinos have another order than the arrays, owned elements followed by
    // ghosts: `places` maps one to the other.
    LevelMatrix::LevelMatrix(const SparseMatrix &A)
      : A(A)
      , n_rows(A.trilinos_matrix().NumMyRows())
      , exchange(A.locally_owned_domain_indices(), ghosts_of(A), A.get_mpi_communicator())
    {
      for (const auto column : global_columns(A))
        places.push_back(exchange.local_index(column));
      columns.resize(places.size());
      ghosts.resize(exchange.n_ghosts());
    }



    // The elements of src at the local columns: owned ones are copied, others are received.
    // Collective.
    const float *
    LevelMatrix::fetch(const float *src) const
    {
      exchange.fetch(src, ghosts.data());
      const std::size_t n = exchange.n_owned();
      for (std::size_t k = 0; k < places.size(); ++k)
        columns[k] = places[k] < n ? src[places[k]] : ghosts[places[k] - n];
      return columns.data();
    }



    void
    LevelMatrix::vmult(float *dst, const float *src) const
    {
      std::fill_n(dst, n_rows, 0.f);
      vmult_add(dst, src);
    }



    // Entries in double precision, vectors in single precision; sums are accumulated in double
    // precision.
    void
    LevelMatrix::vmult_add(float *dst, const float *src) const
    {
      const float *const x = fetch(src);
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          const RowView row(A, i);
          double        sum = 0;
          for (int k = 0; k < row.size; ++k)
            sum += row.values[k] * x[row.columns[k]];
          dst[i] += sum;
        }
    }



    void
    LevelMatrix::Tvmult(float *dst, const float *src) const
    {
      std::fill_n(dst, exchange.n_owned(), 0.f);
      Tvmult_add(dst, src);
    }



    // Contributions by local column are added to the owners. Collective.
    void
    LevelMatrix::Tvmult_add(float *dst, const float *src) const
    {
      std::fill(columns.begin(), columns.end(), 0.f);
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          const RowView row(A, i);
          for (int k = 0; k < row.size; ++k)
            columns[row.columns[k]] += row.values[k] * src[i];
        }
      add_columns(columns.data(), dst);
    }



    // Add values at local columns to the elements of their owners. Collective.
    void
    LevelMatrix::add_columns(const float *values, float *dst) const
    {
      std::fill(ghosts.begin(), ghosts.end(), 0.f);
      const std::size_t n = exchange.n_owned();
      for (std::size_t k = 0; k < places.size(); ++k)
        if (places[k] < n)
          dst[places[k]] += values[k];
        else
          ghosts[places[k] - n] += values[k];
      exchange.add(ghosts.data(), dst);
    }
  } // namespace LA
} // namespace Signorini
