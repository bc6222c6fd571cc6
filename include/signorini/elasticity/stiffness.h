#pragma once

#include <signorini/linear_algebra/products.h>
#include <signorini/parameters/choices.h>

namespace Signorini
{
  /// How products with K are made.
  enum class StiffnessForm
  {
    assembled,  ///< from a matrix
    matrix_free ///< from the cells, each time
  };

  // As the scene file calls them.

  const Choices<StiffnessForm> &
  stiffness_forms();

  /// What the smoother of a level of multigrid asks of a stiffness K.
  class StiffnessOperator
  {
  public:
    virtual ~StiffnessOperator() = default;

    /// dst = K src. Collective.
    virtual void
    vmult(LA::Vector &dst, const LA::Vector &src) const = 0;

    virtual LA::Vector
    diagonal() const = 0;

    /// How large each row is as a whole: the sum of its absolute values, or about as much. Beside
    /// the diagonal it is large where cells are of bad shape.
    virtual LA::Vector
    row_sizes() const = 0;

    /// The degrees of freedom of this rank.
    virtual dealii::IndexSet
    owned() const = 0;

    virtual MPI_Comm
    communicator() const = 0;
  };

  /// K, how the forces of the bodies change with their displacement, with what else solvers ask of
  /// it, such as the rows near contact. Only what cannot do without asks for the whole matrix.
  class Stiffness : public StiffnessOperator
  {
  public:
    virtual void
    vmult_add(LA::Vector &dst, const LA::Vector &src) const = 0;

    /// The same in single precision, if that is quicker: good enough for a preconditioner.
    virtual const StiffnessOperator &
    rounded() const
    {
      return *this;
    }

    /// A matrix in which at least the rows of some degrees of freedom of this rank are complete.
    /// Collective. @param marker nonzero there
    virtual const LA::SparseMatrix &
    rows(const LA::Vector &marker) const = 0;

    /// Collective.
    virtual const LA::SparseMatrix &
    matrix() const = 0;

    /// Another one after each change of values. What was returned before may be void then.
    virtual unsigned int
    version() const = 0;

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

    LA::Vector
    row_sizes() const override;

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
  };
} // namespace Signorini
