// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_space.h"
#include "matrix_free/local_vectors.h"
#include "solid/stiffness.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// The stiffness K of a space by kernels for its cells, with hanging nodes condensed and
  /// prescribed displacements eliminated; its diagonal has also the given diagonal terms, and the
  /// stiffness of the cells at constrained degrees of freedom.
  template <typename Number>
  class CellOperator : public StiffnessOperator<Number>
  {
  public:
    /// The space is not referred to afterwards. Collective.
    explicit CellOperator(const CellSpace &space);

    /// Use the new tangents of the same space. Collective.
    void
    update(const CellSpace &space);

    Number *
    product(const Number *x) const override;

    std::vector<Number>
    diagonal() const override
    {
      return my_diagonal;
    }

    /// Estimated from the largest eigenvalues of cells.
    std::vector<Number>
    row_l1_norms() const override;

    dealii::IndexSet
    owned() const override
    {
      return my_owned;
    }

    MPI_Comm
    communicator() const override
    {
      return comm;
    }

  private:
    const dealii::IndexSet my_owned;
    const MPI_Comm         comm;
    LocalVectors<Number>   vectors;
    /// One for each degree.
    std::vector<std::unique_ptr<CellKernel<Number>>> kernels;
    std::vector<Number>                              my_diagonal;

    /// Diagonal terms in addition to the cells: (local number, value).
    std::vector<std::pair<std::uint32_t, Number>> terms;
  };
} // namespace Signorini
