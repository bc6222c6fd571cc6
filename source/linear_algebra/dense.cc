// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/dense.h"

#include <Eigen/Dense>

namespace Signorini
{
  SymmetricEigenpairs
  eigenpairs_of_symmetric(const Eigen::MatrixXd &matrix)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
  }



  Eigen::VectorXd
  eigenvalues_of_symmetric(const Eigen::MatrixXd &matrix)
  {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues();
  }



  Eigen::VectorXd
  solve_least_squares(const Eigen::MatrixXd &A, const Eigen::VectorXd &b)
  {
    return A.colPivHouseholderQr().solve(b);
  }



  Eigen::MatrixXd
  solve_symmetric(const Eigen::MatrixXd &A, const Eigen::MatrixXd &b)
  {
    return A.ldlt().solve(b);
  }
} // namespace Signorini
