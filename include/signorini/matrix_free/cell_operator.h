#pragma once

#include <signorini/elasticity/elasticity.h>
#include <signorini/matrix_free/cell_kernel.h>
#include <signorini/matrix_free/local_vectors.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// K of bodies in space by kernels for their cells, with hanging nodes condensed and prescribed
  /// displacements eliminated; on its diagonal what Elasticity::diagonal_terms() says, and the
  /// plain stiffness where a degree of freedom is constrained.
  template <typename Number>
  class CellOperator
  {
  public:
    /// The elasticity is not needed any more afterwards. Its degrees are those that there are
    /// kernels for.
    explicit CellOperator(const Elasticity<3> &elasticity);

    /// dst = K src. Collective, as the others.
    void
    vmult(LA::Vector &dst, const LA::Vector &src) const;

    const LA::Vector &
    diagonal() const
    {
      return my_diagonal;
    }

    /// See Stiffness::row_sizes().
    LA::Vector
    row_sizes() const;

    std::size_t
    memory() const;

  private:
    void
    make_diagonal(const Elasticity<3> &elasticity);

    LocalVectors<Number>                             vectors;
    std::vector<std::unique_ptr<CellKernel<Number>>> kernels; ///< one a degree
    LA::Vector                                       my_diagonal, terms;
  };
} // namespace Signorini
