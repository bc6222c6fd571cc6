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
  /// What the smoother of a level of multigrid asks of a stiffness K. Vectors are arrays of the
  /// degrees of freedom of this rank; those of levels are in single precision, which is good enough
  /// for a preconditioner.
  template <typename Number>
  class StiffnessOperator
  {
  public:
    virtual ~StiffnessOperator() = default;

    /// K x, in an array that may be changed, and is valid until the next call. Collective.
    virtual Number *
    product(const Number *x) const = 0;

    /// Where others hang on a degree of freedom, about that.
    virtual std::vector<Number>
    diagonal() const = 0;

    /// How large each row is as a whole: the sum of its absolute values, or about as much. Beside
    /// the diagonal it is large where cells are of bad shape.
    virtual std::vector<Number>
    row_l1_norms() const = 0;

    /// The degrees of freedom of this rank.
    virtual dealii::IndexSet
    owned() const = 0;

    virtual MPI_Comm
    communicator() const = 0;
  };

  /// By a matrix. Refers to it.
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

  /// K, how the forces of the bodies change with their displacement: what solvers ask of it. Only
  /// what cannot do without asks for the whole matrix.
  class Stiffness
  {
  public:
    virtual ~Stiffness() = default;

    /// dst = K src. Collective.
    virtual void
    vmult(LA::Vector &dst, const LA::Vector &src) const = 0;

    virtual void
    vmult_add(LA::Vector &dst, const LA::Vector &src) const = 0;

    /// Where others hang on a degree of freedom, about that.
    virtual LA::Vector
    diagonal() const = 0;

    /// The same for the finest level of multigrid. Collective.
    virtual const StiffnessOperator<float> &
    single_precision() const = 0;

    /// A matrix in which at least the rows of some degrees of freedom of this rank are complete.
    /// Collective. @param marker nonzero there
    virtual const LA::SparseMatrix &
    rows(const LA::Vector &marker) const = 0;

    /// Collective.
    virtual const LA::SparseMatrix &
    matrix() const = 0;

    /// Of the cells of hexahedra that it is the sum of, for coarser spaces; null: they are those of
    /// the materials at rest.
    virtual const CellTangents *
    tangents() const
    {
      return nullptr;
    }

    /// Another one after each change of values. What was returned before may be void then.
    virtual unsigned int
    version() const = 0;

    /// The degrees of freedom of this rank.
    virtual dealii::IndexSet
    owned() const = 0;

    virtual MPI_Comm
    communicator() const = 0;

    dealii::types::global_dof_index
    size() const
    {
      return owned().size();
    }
  };

  /// An assembled one. Refers to the matrix.
  class AssembledStiffness : public Stiffness
  {
  public:
    explicit AssembledStiffness(const LA::SparseMatrix &K)
      : K(K)
    {}

    /// The matrix has other values now.
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
    const LA::SparseMatrix                          &K;
    unsigned int                                     my_version = 1;
    mutable std::unique_ptr<const AssembledOperator> my_single_precision; ///< null: nobody asked
  };
} // namespace Signorini
