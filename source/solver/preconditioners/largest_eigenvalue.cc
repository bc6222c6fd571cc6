// SPDX-License-Identifier: Apache-2.0
#include "solver/preconditioners/largest_eigenvalue.h"

#include <deal.II/base/mpi.h>

#include <cmath>

#include <Eigen/Eigenvalues>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The largest eigenvalue of a symmetric tridiagonal matrix.
    double
    largest_eigenvalue(const std::vector<double> &diagonal, const std::vector<double> &beside)
    {
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
      const std::size_t                              n = diagonal.size();
      solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n),
                                    Eigen::Map<const Eigen::VectorXd>(beside.data(), n - 1),
                                    Eigen::EigenvaluesOnly);
      return solver.eigenvalues().maxCoeff();
    }
  } // namespace



  // Ten steps of conjugate gradients preconditioned by the diagonal: their coefficients are the
  // entries of the Lanczos matrix of D^-1/2 A D^-1/2, whose largest eigenvalue approximates that of
  // D^-1 A from below (doc/theory, 7.1). Ends early if the residual vanishes. Collective.
  double
  largest_eigenvalue(const std::function<const float *(const float *x)> &product,
                     const std::vector<float>                           &inverse_diagonal,
                     std::vector<float>                                  start,
                     const MPI_Comm                                      comm)
  {
    constexpr unsigned int n_steps = 10;
    // Ratio of squared residuals below which nothing is left to find.
    constexpr double little = 1e-20;

    std::vector<float> &r      = start, p(r.size(), 0.f);
    const auto          energy = [&]() {
      double sum = 0;
      for (std::size_t i = 0; i < r.size(); ++i)
        sum += double(r[i]) * inverse_diagonal[i] * r[i];
      return Utilities::MPI::sum(sum, comm);
    };
    std::vector<double> diagonal, beside;
    double              rho = energy(), alpha = 1, beta = 0;
    const double        first = rho;
    for (unsigned int n = 0; n < n_steps && rho > little * first; ++n)
      {
        for (std::size_t i = 0; i < p.size(); ++i)
          p[i] = inverse_diagonal[i] * r[i] + float(beta) * p[i];
        const float *const q  = product(p.data());
        double             pq = 0;
        for (std::size_t i = 0; i < p.size(); ++i)
          pq += double(p[i]) * q[i];
        const double next = rho / Utilities::MPI::sum(pq, comm);
        if (!(next > 0))
          // Rounding errors dominate.
          break;
        if (n > 0)
          beside.push_back(std::sqrt(beta) / alpha);
        diagonal.push_back(1 / next + beta / alpha);
        alpha = next;
        for (std::size_t i = 0; i < r.size(); ++i)
          r[i] -= float(alpha) * q[i];
        const double last = rho;
        rho               = energy();
        beta              = rho / last;
      }
    return diagonal.empty() ? 0 : largest_eigenvalue(diagonal, beside);
  }
} // namespace Signorini
