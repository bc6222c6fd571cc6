// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpi.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /// An estimate of the largest eigenvalue of D^-1 A for a symmetric positive definite A, from
  /// below: the largest eigenvalue of the Lanczos matrix of a few steps of conjugate gradients
  /// (doc/theory, 7.1; Saad, Iterative Methods for Sparse Linear Systems, 6.7.3). A power iteration
  /// with twice as many products underestimates so much that smoothers may diverge. Vectors are
  /// arrays of the elements that this rank owns. Collective.
  /// @param product A x, in an array that is valid until the next call
  /// @param inverse_diagonal the diagonal of D^-1
  /// @param start start vector; it must have a component along the eigenvector of the largest
  /// eigenvalue
  double
  largest_eigenvalue(const std::function<const float *(const float *x)> &product,
                     const std::vector<float>                           &inverse_diagonal,
                     std::vector<float>                                  start,
                     MPI_Comm                                            comm);
} // namespace Signorini
