// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/level_matrix.h"
#include "linear_algebra/products.h"

#include <memory>

namespace Signorini
{
  /// From a level of multigrid to the one above it. Vectors are arrays of this rank's degrees of
  /// freedom.
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

    /// B P for a matrix B with few columns, on the level above. Collective.
    virtual LA::SparseMatrix
    times(const LA::SparseMatrix &B) const = 0;
  };

  /// By a matrix.
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
