// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace Signorini
{
  /// Decompositions of small dense matrices, by Eigen. They are compiled here once, and not in each
  /// file that needs one: that takes seconds each time.

  struct SymmetricEigenpairs
  {
    Eigen::VectorXd values;  ///< ascending
    Eigen::MatrixXd vectors; ///< orthonormal columns, in the order of the values
  };

  /// The eigenvalues and eigenvectors of a symmetric matrix, of which the lower triangle is read.
  SymmetricEigenpairs
  eigenpairs_of_symmetric(const Eigen::MatrixXd &matrix);

  /// Ascending, of a symmetric matrix, of which the lower triangle counts.
  Eigen::VectorXd
  eigenvalues_of_symmetric(const Eigen::MatrixXd &matrix);

  /// The x for which |A x - b| is least, by QR with pivots; A has at least as many rows as columns.
  Eigen::VectorXd
  solve_least_squares(const Eigen::MatrixXd &A, const Eigen::VectorXd &b);

  /// The x with A x = b for symmetric A, of which the lower triangle counts, by L D L^T with
  /// pivots.
  Eigen::MatrixXd
  solve_symmetric(const Eigen::MatrixXd &A, const Eigen::MatrixXd &b);
} // namespace Signorini
