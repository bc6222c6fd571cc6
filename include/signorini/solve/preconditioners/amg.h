#pragma once

#include <signorini/linear_algebra.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <vector>

namespace Signorini
{
  /// Smoothed-aggregation multigrid (ML) for the stiffness matrix, whose near-null-space are the
  /// rigid-body modes: translations alone cost twice the iterations, and the count then grows with
  /// the mesh.
  class AMG
  {
  public:
    /// @param modes rigid-body modes on the locally owned degrees of freedom, mode by mode
    AMG(const LA::SparseMatrix                 &stiffness,
        const std::vector<std::vector<double>> &modes,
        unsigned int                            dim);

    /// One V-cycle.
    void
    vmult(LA::Vector &dst, const LA::Vector &src) const;

    unsigned int
    v_cycles() const
    {
      return n_v_cycles;
    }

  private:
    dealii::TrilinosWrappers::PreconditionAMG amg;
    mutable unsigned int                      n_v_cycles = 0;
  };
} // namespace Signorini
