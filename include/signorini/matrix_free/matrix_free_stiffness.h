#pragma once

#include <signorini/elasticity/stiffness.h>
#include <signorini/matrix_free/cell_operator.h>

#include <memory>

namespace Signorini
{
  /// K of linear elasticity in space whose products are made by the cells. Whoever asks for rows
  /// gets them assembled from the cells around them.
  class MatrixFreeStiffness : public Stiffness
  {
  public:
    /// Refers to the elasticity. Collective.
    explicit MatrixFreeStiffness(const Elasticity<3> &elasticity);

    void
    vmult(LA::Vector &dst, const LA::Vector &src) const override;

    void
    vmult_add(LA::Vector &dst, const LA::Vector &src) const override;

    LA::Vector
    diagonal() const override;

    const StiffnessOperator<float> &
    rounded() const override
    {
      return in_single_precision;
    }

    /// What was returned before is void if there are marks that it had not.
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
      return 1;
    }

  private:
    MatrixFreeStiffness(const Elasticity<3> &elasticity, const CellSpace &space);

    const Elasticity<3>                      &elasticity;
    const CellOperator<double>                cells;
    const CellOperator<float>                 in_single_precision;
    mutable LA::Vector                        marked; ///< the rows that there are, empty: none
    mutable std::unique_ptr<LA::SparseMatrix> some_rows;
  };
} // namespace Signorini
