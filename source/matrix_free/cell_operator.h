// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_space.h"
#include "matrix_free/local_vectors.h"
#include "solid/stiffness.h"

#include <memory>
#include <vector>

namespace Signorini
{
  /// K by kernels for the cells of a space, with hanging nodes condensed and prescribed
  /// displacements eliminated; on its diagonal also the space's terms, and the plain stiffness
  /// where a degree of freedom is constrained.
  template <typename Number>
  class CellOperator : public StiffnessOperator<Number>
  {
  public:
    /// The space is not needed any more afterwards.
    explicit CellOperator(const CellSpace &space);

    /// The space has other tangents now. Collective.
    void
    update(const CellSpace &space);

    Number *
    product(const Number *x) const override;

    std::vector<Number>
    diagonal() const override
    {
      return my_diagonal;
    }

    /// From the eigenvalues of cells.
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
    const dealii::IndexSet                           my_owned;
    const MPI_Comm                                   comm;
    LocalVectors<Number>                             vectors;
    std::vector<std::unique_ptr<CellKernel<Number>>> kernels; ///< one a degree
    std::vector<Number>                              my_diagonal;

    /// What is on the diagonal beyond the cells: local number, value.
    std::vector<std::pair<std::uint32_t, Number>> terms;
  };
} // namespace Signorini
