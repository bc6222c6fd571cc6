// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/level_matrix.h"
#include "linear_algebra/products.h"

#include <memory>

namespace Signorini
{
  /// The prolongation from a multigrid level to the next finer one. Vectors are arrays of the owned
  /// degrees of freedom of this rank.
  class Prolongation
  {
  public:
    virtual ~Prolongation() = default;

    /// fine += P coarse. Collective.
    virtual void
    vmult_add(float *fine, const float *coarse) const = 0;

    /// coarse = P^T fine. Collective.
    virtual void
    Tvmult(float *coarse, const float *fine) const = 0;

    /// The product B P with a matrix B on the finer level that has few columns. Collective.
    virtual LA::SparseMatrix
    times(const LA::SparseMatrix &B) const = 0;
  };

  /// A prolongation by an assembled matrix.
  class AssembledProlongation : public Prolongation
  {
  public:
    explicit AssembledProlongation(LA::SparseMatrix &&matrix)
      : P(std::move(matrix))
      , single_precision(P)
    {}

    void
    vmult_add(float *fine, const float *coarse) const override
    {
      single_precision.vmult_add(fine, coarse);
    }

    void
    Tvmult(float *coarse, const float *fine) const override
    {
      single_precision.Tvmult(coarse, fine);
    }

    LA::SparseMatrix
    times(const LA::SparseMatrix &B) const override
    {
      return LA::product(B, P);
    }

  private:
    const LA::SparseMatrix P;
    const LA::LevelMatrix  single_precision;
  };
} // namespace Signorini
