// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpi.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /// About the largest eigenvalue of D^-1 A for a symmetric positive definite A, from below, by the
  /// numbers that a few steps of conjugate gradients leave behind (Saad, Iterative Methods for
  /// Sparse Linear Systems, 6.7.3). A power iteration of twice as many products underestimates so
  /// much that smoothers may diverge. Vectors are arrays of this rank's elements. Collective.
  /// @param product A x, in an array that is valid until the next call
  /// @param inverse_diagonal of D
  /// @param start what is to be found must have a part in it
  double
  largest_eigenvalue(const std::function<const float *(const float *x)> &product,
                     const std::vector<float>                           &inverse_diagonal,
                     std::vector<float>                                  start,
                     MPI_Comm                                            comm);
} // namespace Signorini
