// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "matrix_free/cell_operator.h"
#include "solid/stiffness.h"

#include <functional>
#include <memory>
#include <optional>

namespace Signorini
{
  /// K of bodies in space whose products are made by the cells. Whoever asks for rows gets them
  /// assembled from the cells around them.
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

    /// What was returned before is void if there are marks that it had not, and once somebody asks
    /// for the whole matrix.
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

    /// Refers to the elasticity. The operators are to be set.
    explicit CellStiffness(const Elasticity<3> &elasticity)
      : elasticity(elasticity)
    {}

    /// The operators have changed.
    void
    has_changed();

    /// Sum of the matrices of the cells that are taken. Collective.
    virtual void
    assemble(LA::SparseMatrix &K, const std::function<bool(const Cell &)> &takes) const = 0;

    const Elasticity<3>                &elasticity;
    std::optional<CellOperator<double>> in_double_precision;
    std::optional<CellOperator<float>>  in_single_precision;

  private:
    unsigned int                              my_version = 1;
    mutable LA::Vector                        marked; ///< rows that were asked for, empty: none
    mutable std::unique_ptr<LA::SparseMatrix> some_rows, whole; ///< null: nobody asked
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
