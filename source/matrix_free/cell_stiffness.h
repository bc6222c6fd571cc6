// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_operator.h"
#include "solid/stiffness.h"

#include <functional>
#include <memory>
#include <optional>

namespace Signorini
{
  /// A stiffness of bodies in space whose products are evaluated cell by cell. Rows and the whole
  /// matrix are assembled from cells on request.
  class CellStiffness : public Stiffness
  {
  public:
    void
    vmult(LA::Vector &dst, const LA::Vector &src) const override;

    void
    vmult_add(LA::Vector &dst, const LA::Vector &src) const override;

    LA::Vector
    diagonal() const override;

    const StiffnessOperator<float> &
    single_precision() const override
    {
      return *in_single_precision;
    }

    /// Rows of marked degrees of freedom. A matrix returned earlier is invalid after a call with
    /// new marks, and after matrix().
    const LA::SparseMatrix &
    rows(const LA::Vector &marker) const override;

    const LA::SparseMatrix &
    matrix() const override;

    dealii::IndexSet
    owned() const override
    {
      return elasticity.owned();
    }

    MPI_Comm
    communicator() const override
    {
      return elasticity.mesh().communicator();
    }

    unsigned int
    version() const override
    {
      return my_version;
    }

  protected:
    using Cell = dealii::DoFHandler<3>::active_cell_iterator;

    /// Refers to the elasticity. Derived classes set the operators.
    explicit CellStiffness(const Elasticity<3> &elasticity)
      : elasticity(elasticity)
    {}

    /// To be called when the operators have changed; assembled matrices are discarded.
    void
    has_changed();

    /// Assemble the cells for which `takes` is true. Collective.
    virtual void
    assemble(LA::SparseMatrix &K, const std::function<bool(const Cell &)> &takes) const = 0;

    const Elasticity<3>                &elasticity;
    std::optional<CellOperator<double>> in_double_precision;
    std::optional<CellOperator<float>>  in_single_precision;

  private:
    unsigned int my_version = 1;
    /// Degrees of freedom whose rows have been requested (nonzero); empty: none.
    mutable LA::Vector marked;
    /// The matrices that have been requested; null: none.
    mutable std::unique_ptr<LA::SparseMatrix> some_rows, whole;
  };

  /// The stiffness of linear elasticity by cells.
  class MatrixFreeStiffness : public CellStiffness
  {
  public:
    /// Refers to the elasticity. Collective.
    explicit MatrixFreeStiffness(const Elasticity<3> &elasticity);

  protected:
    void
    assemble(LA::SparseMatrix &K, const std::function<bool(const Cell &)> &takes) const override;
  };
} // namespace Signorini
