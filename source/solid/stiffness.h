// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "linear_algebra/level_matrix.h"
#include "linear_algebra/products.h"
#include "solid/cell_tangents.h"
#include <signorini/solid/stiffness_form.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /// A stiffness K as the smoother of a multigrid level uses it. Vectors are arrays of the owned
  /// degrees of freedom of this rank; on levels they are in single precision, which suffices for a
  /// preconditioner.
  template <typename Number>
  class StiffnessOperator
  {
  public:
    virtual ~StiffnessOperator() = default;

    /// The product K x, in an array that the caller may change, valid until the next call.
    /// Collective.
    /// @param x owned degrees of freedom of this rank
    virtual Number *
    product(const Number *x) const = 0;

    /// The diagonal of K. At degrees of freedom that constrain hanging nodes the value is
    /// approximate.
    virtual std::vector<Number>
    diagonal() const = 0;

    /// The l1 norm of each row, or an approximation of it. Its ratio to the diagonal is large where
    /// cells are of bad shape.
    virtual std::vector<Number>
    row_l1_norms() const = 0;

    /// The degrees of freedom that this rank owns.
    virtual dealii::IndexSet
    owned() const = 0;

    /// The communicator of all ranks.
    virtual MPI_Comm
    communicator() const = 0;
  };

  /// A stiffness operator with an assembled matrix, to which it keeps a reference.
  class AssembledOperator : public StiffnessOperator<float>
  {
  public:
    explicit AssembledOperator(const LA::SparseMatrix &K);

    float *
    product(const float *x) const override
    {
      K_single.vmult(result.data(), x);
      return result.data();
    }

    std::vector<float>
    diagonal() const override;

    std::vector<float>
    row_l1_norms() const override;

    dealii::IndexSet
    owned() const override
    {
      return K.locally_owned_range_indices();
    }

    MPI_Comm
    communicator() const override
    {
      return K.get_mpi_communicator();
    }

  private:
    const LA::SparseMatrix    &K;
    const LA::LevelMatrix      K_single;
    mutable std::vector<float> result;
  };

  /// The stiffness K of the bodies, the derivative of the internal forces with respect to the
  /// displacement, as the solvers use it. Products do not need an assembled matrix; it is assembled
  /// only where a preconditioner needs it.
  class Stiffness
  {
  public:
    virtual ~Stiffness() = default;

    /// dst = K src. Collective.
    virtual void
    vmult(LA::Vector &dst, const LA::Vector &src) const = 0;

    /// dst += K src. Collective.
    virtual void
    vmult_add(LA::Vector &dst, const LA::Vector &src) const = 0;

    /// The diagonal of K. At degrees of freedom that constrain hanging nodes the value is
    /// approximate. Collective.
    virtual LA::Vector
    diagonal() const = 0;

    /// K in single precision, for the finest level of multigrid. Collective.
    virtual const StiffnessOperator<float> &
    single_precision() const = 0;

    /// A matrix in which at least the rows of the marked degrees of freedom of this rank are
    /// complete. Collective.
    /// @param marker nonzero at these degrees of freedom
    virtual const LA::SparseMatrix &
    rows(const LA::Vector &marker) const = 0;

    /// The assembled matrix. Collective.
    virtual const LA::SparseMatrix &
    matrix() const = 0;

    /// The tangents of the hexahedral cells that K is assembled from, for coarser spaces; null:
    /// they are those of the undeformed materials.
    virtual const CellTangents *
    tangents() const
    {
      return nullptr;
    }

    /// Changes with each change of values; references returned before may be invalid then.
    virtual unsigned int
    version() const = 0;

    /// The degrees of freedom that this rank owns.
    virtual dealii::IndexSet
    owned() const = 0;

    /// The communicator of all ranks.
    virtual MPI_Comm
    communicator() const = 0;

    /// The number of degrees of freedom of all ranks.
    dealii::types::global_dof_index
    size() const
    {
      return owned().size();
    }
  };

  /// A stiffness with an assembled matrix, to which it keeps a reference.
  class AssembledStiffness : public Stiffness
  {
  public:
    explicit AssembledStiffness(const LA::SparseMatrix &K)
      : K(K)
    {}

    /// To be called when the values of the matrix have changed.
    void
    has_changed()
    {
      ++my_version;
      my_single_precision.reset();
    }

    void
    vmult(LA::Vector &dst, const LA::Vector &src) const override
    {
      LA::multiply(K, dst, src);
    }

    void
    vmult_add(LA::Vector &dst, const LA::Vector &src) const override
    {
      K.vmult_add(dst, src);
    }

    LA::Vector
    diagonal() const override;

    const StiffnessOperator<float> &
    single_precision() const override;

    const LA::SparseMatrix &
    rows(const LA::Vector & /*marker*/) const override
    {
      return K;
    }

    const LA::SparseMatrix &
    matrix() const override
    {
      return K;
    }

    dealii::IndexSet
    owned() const override
    {
      return K.locally_owned_range_indices();
    }

    MPI_Comm
    communicator() const override
    {
      return K.get_mpi_communicator();
    }

    unsigned int
    version() const override
    {
      return my_version;
    }

  private:
    const LA::SparseMatrix &K;
    unsigned int            my_version = 1;
    /// Null until it is needed.
    mutable std::unique_ptr<const AssembledOperator> my_single_precision;
  };
} // namespace Signorini
