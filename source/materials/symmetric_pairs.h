// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace Signorini
{
  /// A symmetric 3 x 3 tensor as an array of its six different components. Sums of products of such
  /// arrays form tensors of fourth order by simple loops, which is faster than
  /// dealii::outer_product() over all four indices.
  struct SymmetricPairs
  {
    static constexpr unsigned int                size   = 6;
    static constexpr std::array<unsigned int, 6> row    = {{0, 1, 2, 0, 0, 1}},
                                                 column = {{0, 1, 2, 1, 2, 2}};

    using Values = std::array<double, size>;

    /// @return the components of a tensor.
    static Values
    of(const dealii::SymmetricTensor<2, 3> &A)
    {
      Values result;
      for (unsigned int p = 0; p < size; ++p)
        result[p] = A[row[p]][column[p]];
      return result;
    }

    /// @return a pointer to the six components of T whose first pair is p; deal.II stores pairs in
    /// the same order.
    static double *
    row_of(dealii::SymmetricTensor<4, 3> &T, const unsigned int p)
    {
      return T.begin_raw() + size * p;
    }

    static const double *
    row_of(const dealii::SymmetricTensor<4, 3> &T, const unsigned int p)
    {
      return T.begin_raw() + size * p;
    }
  };
} // namespace Signorini
