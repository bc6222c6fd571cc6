#pragma once

#include <signorini/solve/preconditioner.h>

namespace Signorini
{
  /// diag(AMG, S) or the block triangular form of it, with the diagonal S = diag(A B diag(K)^-1 B^T
  /// A) of an approximate Schur complement. On condensed systems both are AMG(K) alone.
  class BlockPreconditioner : public Preconditioner
  {
  public:
    BlockPreconditioner(const ContactSystem &system, const AMG &amg, bool triangular);

    void
    update() override;

    void
    vmult(LA::BlockVector &dst, const LA::BlockVector &src) const override;

    bool
    is_positive_definite() const override
    {
      return !triangular;
    }

  private:
    const ContactSystem &system;
    const AMG           &amg;
    const bool           triangular;
    LA::Vector           flexibility; ///< diag(B diag(K)^-1 B^T)
    LA::Vector           inverse_schur;
    mutable LA::Vector   rest;
  };
} // namespace Signorini
