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
    /// this rank, in single precision. Refers to the matrix. Products are collective.
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

    private:
      const float *
      fetch(const float *src) const;

      const SparseMatrix        &A;
      const unsigned int         n_rows;
      std::vector<std::uint32_t> places; ///< of local columns in the exchange
      GhostExchange<float>       exchange;
      mutable std::vector<float> columns, ghosts;
    };
  } // namespace LA
} // namespace Signorini
