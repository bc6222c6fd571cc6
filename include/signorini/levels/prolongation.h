#pragma once

#include <signorini/linear_algebra/products.h>

namespace Signorini
{
  /// From a level of multigrid to the one above it.
  class Prolongation
  {
  public:
    virtual ~Prolongation() = default;

    /// fine = P coarse
    virtual void
    vmult(LA::Vector &fine, const LA::Vector &coarse) const = 0;

    /// coarse = P^T fine
    virtual void
    Tvmult(LA::Vector &coarse, const LA::Vector &fine) const = 0;

    /// B P for a matrix B with few columns, on the level above.
    virtual LA::SparseMatrix
    times(const LA::SparseMatrix &B) const = 0;
  };

  class AssembledProlongation : public Prolongation
  {
  public:
    explicit AssembledProlongation(LA::SparseMatrix &&P)
      : P(std::move(P))
    {}

    void
    vmult(LA::Vector &fine, const LA::Vector &coarse) const override
    {
      LA::multiply(P, fine, coarse);
    }

    void
    Tvmult(LA::Vector &coarse, const LA::Vector &fine) const override
    {
      LA::multiply_transposed(P, coarse, fine);
    }

    LA::SparseMatrix
    times(const LA::SparseMatrix &B) const override
    {
      return LA::product(B, P);
    }

  private:
    const LA::SparseMatrix P;
  };
} // namespace Signorini
